#include "support.h"

TEST_CASE("triangle placeholder") { CHECK(true); }
