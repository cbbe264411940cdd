#pragma once

#include <memory>
#include <stdexcept>

#include "app/options.h"
#include "swAdaptive.h"
#include "swRenderer.h"

/// A signal has ended the render early.
class Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    /// Of the program, as shells have it: 128 and the signal's number.
    static int exitCode();
};

/// What goes on beside a render: progress, preview, and looking out for signals.
class RenderWatch {
public:
    /// @throws UsageError if there can be no preview
    RenderWatch(const Options& options, const sw::Color& background);
    ~RenderWatch();
    RenderWatch(const RenderWatch&) = delete;
    RenderWatch& operator=(const RenderWatch&) = delete;

    const sw::RenderOptions& how() const { return renderOptions; }
    /// For adaptive sampling. True: it goes on.
    bool passDone(const sw::AdaptiveProgress& progress);
    /// Whether anybody wants to know of passes.
    bool showsPasses() const;

    /// Ends the watch.
    /// @throws Interrupted if pixels are missing
    void end(const sw::RenderResult& result);

private:
    struct Parts;
    std::unique_ptr<Parts> parts;
    sw::RenderOptions renderOptions;
};

/// Tells of a picture that lacks something, and is written all the same.
/// @throws Interrupted if that is because of a signal
void tellOfLack(const Options& options, const sw::RenderResult& result);
