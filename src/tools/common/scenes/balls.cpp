#include "tools/common/nffText.h"
#include "tools/common/scenes/scenes.h"
#include "tools/common/sphereflake.h"

namespace scenes {

std::string balls(int size) {
    NffText text({2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1});
    text.light({4, 3, 2});
    text.light({1, -4, 4});
    text.light({-3, 1, 5});
    text.material({1, 0.75, 0.33}, 0.8, 0);
    text.square({12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5});
    text.material({1, 0.9, 0.7}, 0.5, 0.5);
    std::size_t count = 1;
    for (int i = 0; i < size; ++i) count = 9 * count + 1;
    for (const Ball& ball : sphereflake(count, {0, 0, 1})) text.sphere(ball.center, ball.radius);
    return text.take();
}

}  // namespace scenes
