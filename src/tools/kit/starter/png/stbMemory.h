#pragma once

// Here, stb_image_write takes its memory where every program does.
struct StbMemory {
    StbMemory() {}
};
