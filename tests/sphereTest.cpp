#include "support.h"

TEST_CASE("sphere placeholder") { CHECK(true); }
