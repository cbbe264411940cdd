#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "app/pictureFormat.h"
#include "swRenderer.h"

/// Writes a picture once a second while it is rendered, whole as ever: tiles to come have the
/// background's colour. A picture that cannot be written ends the preview; the render goes on.
class Preview {
public:
    /// @param window  of the picture; the file shows this part
    Preview(std::filesystem::path file, float gamma, const sw::Window& window,
            const sw::Color& background);
    /// Waits for the picture that is being written.
    ~Preview();
    Preview(const Preview&) = delete;
    Preview& operator=(const Preview&) = delete;

    /// Takes the pixels of a tile. Any thread may call it.
    void show(const sw::Window& tile, const sw::ColorAt& colors);

private:
    void run();

    const std::filesystem::path file;
    const PictureFormat format;
    const float gamma;
    const sw::Window window;

    std::mutex mutex;  // guards what follows
    std::condition_variable ending;
    sw::Image picture;
    bool hasChanged = false;
    bool ends = false;

    std::thread writer;
};
