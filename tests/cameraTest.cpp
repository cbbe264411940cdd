#include "support.h"

TEST_CASE("camera placeholder") { CHECK(true); }
