"""What .ci/page uses: the browser, the program, and their two accounts of a pixel's rays."""
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

PROJECT = pathlib.Path(__file__).resolve().parent.parent
BUILD = (PROJECT / (sys.argv[1] if len(sys.argv) > 1 else "build")).resolve()
WORK = pathlib.Path(tempfile.mkdtemp())


def fail(message):
    sys.exit(f"page: {message}")


def expect(is_right, message):
    if not is_right:
        fail(message)


# ---- the browser


def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--window-size=1280,1000"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def open_page(driver, page):
    """Opens a page and waits until it shows its rays; nothing may go wrong, or over a network."""
    driver.get_log("performance")
    driver.get(page.as_uri())
    for _ in range(300):
        if driver.execute_script("return document.body.dataset.ready"):
            break
        time.sleep(0.1)
    else:
        fail(f"{page.name} does not get ready: {driver.get_log('browser')}")
    check_quiet(driver, page)


def check_quiet(driver, page):
    errors = driver.get_log("browser")
    expect(not errors, f"{page.name}: expected an empty console, found {errors}")
    for entry in driver.get_log("performance"):
        found = re.search(r'"Network.requestWillBeSent".*?"url":"([^"]*)"', entry["message"])
        if found and not found[1].startswith("data:"):
            expect(found[1] == page.as_uri(), f"{page.name} asks for {found[1][:200]}")


def make_page(program, name, *arguments):
    page = WORK / f"{name}.html"
    command = [program, *arguments, "--explore", page, "-o", WORK / "out.png", "--quiet"]
    subprocess.run(command, capture_output=True, check=False, cwd=WORK)
    expect(page.exists(), f"expected a page of {command}")
    return page


# ---- what --pixel prints, and what the page shows, as the same list of rays


NUMBER = r"[-+0-9.e]+|nan|inf|-inf"


def numbers(text):
    return [float(n) for n in re.findall(NUMBER, text.replace("infinity", "inf").replace("NaN", "nan"))]


def ray_of(level, headline, details):
    """Kind, level, state or colour, weight, shape and place of a ray."""
    ray = {"level": level, "kind": headline.split(" ", 1)[0], "lit": headline.split(": ")[-1].split(",")[0]}
    colour = re.search(r"colour \(([^)]*)\)", headline)
    weight = re.search(r"weight ([-0-9.e]+)", headline)
    ray["colour"] = numbers(colour[1]) if colour else None
    if colour:
        ray["lit"] = ""
    ray["weight"] = [float(weight[1])] if weight else None
    hit = re.search(r"hits (\w+ \(line \d+).*?\)(?:, (front|back), t = (\S+))? at \(([^)]*)\)", details)
    ray["shape"], ray["side"] = (hit[1], hit[2]) if hit and colour else (hit[1] if hit else None, None)
    ray["place"] = numbers(hit[4]) if hit else None
    ray["t"] = [float(hit[3])] if hit and hit[3] and colour else None
    return ray


def printed(program, x, y, arguments):
    run = subprocess.run([program, *arguments, "--pixel", f"{x},{y}"], capture_output=True, text=True,
                         check=True, cwd=WORK)
    rays = []
    for line in run.stdout.splitlines():
        bare = line.lstrip("|+- ")
        if re.match(r"(primary|shadow|reflected|refracted|other) ray", bare):
            rays.append([(len(line) - len(bare)) // 3 + 1, bare, ""])
        elif rays:
            rays[-1][2] += bare + "\n"
    shown = re.search(r"shown as (\d+ \d+ \d+)", run.stdout)
    return [ray_of(*ray) for ray in rays], shown[1] if shown else None


def on_page(driver):
    rays = driver.execute_script("""return [...document.querySelectorAll('.ray')].map((item) =>
        [Number(item.getAttribute('aria-level')), item.firstChild.textContent,
         [...item.querySelectorAll('span')].map((line) => line.textContent).join('\\n')]);""")
    shown = re.search(r"shown as (\d+ \d+ \d+)", driver.find_element(By.ID, "pixel").text)
    return [ray_of(*ray) for ray in rays], shown[1]


def is_near(a, b, relative, absolute):
    if a is None or b is None:
        return a is b
    largest = max(map(abs, a + b))
    return all(abs(p - q) <= relative * largest + absolute for p, q in zip(a, b))


def check_same(where, expected, found):
    expect(len(expected) == len(found), f"{where}: expected {len(expected)} rays, found {len(found)}")
    for k, (a, b) in enumerate(zip(expected, found)):
        for key in ["level", "kind", "lit", "shape", "side"]:
            expect(a[key] == b[key], f"{where}, ray {k}: expected {key} {a[key]}, found {b[key]}")
        for key, relative in [("place", 6e-5), ("t", 2e-4), ("colour", 1e-3), ("weight", 2e-3)]:
            expect(is_near(a[key], b[key], relative, 2e-4 if key == "t" else 1e-5),
                   f"{where}, ray {k}: expected {key} {a[key]}, found {b[key]}")
