#include "app/preview.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "swFile.h"

Preview::Preview(std::filesystem::path file, float gamma, const sw::Window& window,
                 const sw::Color& background)
    : file(std::move(file)),
      format(formatOf(this->file).value_or(PictureFormat::png)),
      gamma(gamma),
      window(window),
      picture(window.width(), window.height()) {
    for (int y = 0; y < window.height() && !background.isZero(); ++y)
        for (int x = 0; x < window.width(); ++x) picture.at(x, y) = background;
    try {
        writer = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        // No threads are left: the picture is shown at its end, as without a preview.
    }
}

Preview::~Preview() {
    {
        const std::lock_guard lock(mutex);
        ends = true;
    }
    ending.notify_all();
    if (writer.joinable()) writer.join();
}

void Preview::show(const sw::Window& tile, const sw::ColorAt& colors) {
    const std::lock_guard lock(mutex);
    for (int y = std::max(tile.y0, window.y0); y < std::min(tile.y1, window.y1); ++y)
        for (int x = std::max(tile.x0, window.x0); x < std::min(tile.x1, window.x1); ++x)
            picture.at(x - window.x0, y - window.y0) = colors(x, y);
    hasChanged = true;
}

void Preview::run() {
    try {
        for (std::unique_lock lock(mutex); !ends;) {
            if (ending.wait_for(lock, std::chrono::seconds(1), [this] { return ends; })) return;
            if (!std::exchange(hasChanged, false)) continue;
            const sw::Image now = picture;
            lock.unlock();
            sw::writeFile(file, encode(now, format, gamma));
            lock.lock();
        }
    } catch (const std::exception&) {
        // No memory or no disk space: the end of the render will tell.
    }
}
