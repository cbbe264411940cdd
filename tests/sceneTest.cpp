#include "support.h"

TEST_CASE("scene placeholder") { CHECK(true); }
