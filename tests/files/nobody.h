#pragma once

#include <unistd.h>

namespace test {

/// If the tests run as root, who may do everything: takes the rights of nobody meanwhile.
class AsNobody {
public:
    AsNobody() : wasRoot(geteuid() == 0 && seteuid(65534) == 0) {}
    ~AsNobody() {
        if (wasRoot && seteuid(0) != 0) _exit(1);
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

    const bool wasRoot;
};

}  // namespace test
