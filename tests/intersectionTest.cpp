#include "support.h"

TEST_CASE("intersection placeholder") { CHECK(true); }
