#include "tools/convergence/convergencePage.h"
#include "nff/plainText.h"

#include "tools/common/html.h"
#include "tools/common/table.h"
#include "tools/convergence/convergencePlot.h"
#include "tools/convergence/convergenceTables.h"

namespace report {
namespace {

using html::escaped;
using html::figure;

namespace fs = std::filesystem;

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>swTracer: error against run time</title>
<style>
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; margin: 0 auto; padding: 1rem;
  max-width: 70rem; }
h2 { border-top: 1px solid #ccc; padding-top: 1rem; }
nav a { margin-right: .8em; }
figure { margin: 0; }
figcaption { font-size: .85rem; color: #555; }
img { max-width: 100%; height: auto; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
.picture { width: 10.4rem; }
.picture img { width: 100%; image-rendering: pixelated; }
.plot { flex: 0 1 33rem; }
.plot img { width: 100%; }
.table { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .85rem; }
th, td { padding: .15rem .6rem; border-bottom: 1px solid #ddd; text-align: left;
  vertical-align: bottom; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
td { white-space: nowrap; }
.scale { height: 1rem; max-width: 24rem;
  background: linear-gradient(to right, #000, #00f, #f00, #ff0, #fff); border: 1px solid #888; }
.labels { display: flex; justify-content: space-between; max-width: 24rem; font-size: .85rem; }
</style></head><body>
<h1>Error against run time</h1>
)";

constexpr const char* howToRead = R"(
<p>Each method renders each scene at several settings. The pictures are compared with a converged
reference. RMSE is the root mean square difference of the channels in linear radiance, clamped to 0..1
as in the picture. In the plots, lower is better and further left is cheaper. Both axes are
logarithmic: an error that falls like cost<sup>slope</sup> is a straight line. Theory expects
-0.5 over the samples for <em>random</em>, and -0.75 for <em>jitter</em> where the error lies at
edges. The slopes exclude the samplers' 1x1, which is the pixel's centre for most of them.</p>
<p>The heat maps show the error of one picture in every pixel:</p>
<div class="scale"></div>
<div class="labels"><span>0.0001</span><span>0.001</span><span>0.01</span><span>0.1</span><span>1</span></div>
)";

std::string paragraph(const std::string& text) {
    return "<p>" + escaped(text) + "</p>\n";
}

std::string plots(const Study& study, const fs::path& folder) {
    std::string html;
    for (const Cost cost : {Cost::seconds, Cost::samples}) {
        const fs::path file = folder / plotName(study, cost).concat(".svg");
        if (fs::exists(file))
            html += figure(
                file,
                study.scene + ": error against " + (cost == Cost::seconds ? "run time" : "samples"),
                "plot");
    }
    return "<div class=\"row\">" + html + "</div>\n";
}

std::string picture(const sw::Image& image, const fs::path& file, const std::string& caption) {
    sw::writePng(image, file);
    return figure(file, caption, "picture");
}

// The reference and the heat maps of a few methods.
std::string pictures(const Study& study, const fs::path& folder) {
    std::string html = picture(study.reference, folder / (study.scene + "-reference.png"),
                               study.scene + ", the reference");
    for (const ErrorPicture& error : study.errors) {
        const std::string name = error.method + "-" + error.setting;
        html += picture(error.image, folder / (study.scene + "-" + name + ".png"),
                        "error of " + error.method + " " + error.setting);
    }
    return "<div class=\"row\">" + html + "</div>\n";
}

std::string section(const Study& study, const fs::path& folder) {
    auto reference = sw::plainStream();
    reference << study.reference.width() << " x " << study.reference.height()
              << " pixels; estimated RMSE of the reference: " << study.referenceError
              << ". Errors close to this are partly the reference's.";
    return "<h2 id=\"" + escaped(study.scene) + "\">" + escaped(study.scene) + "</h2>\n" +
           pictures(study, folder) + plots(study, folder) + paragraph(reference.str()) +
           "<details><summary>All numbers</summary>" + htmlTable(measurementRows(study), 2) +
           "</details>\n";
}

}  // namespace

std::string convergencePage(const std::vector<Study>& studies, const Study& all,
                            const fs::path& folder, const std::vector<std::string>& remarks) {
    std::string html = head;
    for (const std::string& remark : remarks) html += paragraph(remark);
    html += "<nav>";
    for (const Study& study : studies)
        html += "<a href=\"#" + escaped(study.scene) + "\">" + escaped(study.scene) + "</a> ";
    html += std::string("</nav>\n") + howToRead +
            "<h2>All scenes</h2>\n<p>Geometric means over the scenes.</p>\n" + plots(all, folder) +
            htmlTable(samplerRows(all), 1) +
            "<h3>How many times less run time than jitter, for the same error</h3>\n" +
            htmlTable(speedUpRows(studies, Cost::seconds), 1) +
            "<h3>How many times fewer samples</h3>\n" +
            htmlTable(speedUpRows(studies, Cost::samples), 1);
    for (const Study& study : studies) html += section(study, folder);
    return html + "</body></html>\n";
}

}  // namespace report
