#include "tools/bench/memory.h"

#ifdef __linux__
#include <malloc.h>
#include <sched.h>
#endif

namespace bench {

std::optional<std::size_t> allocatedBytes() {
#ifdef __GLIBC_PREREQ
#if __GLIBC_PREREQ(2, 33)
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
#endif
    return std::nullopt;
}

#ifdef __linux__

struct OneProcessor::Before {
    cpu_set_t processors;
};

OneProcessor::OneProcessor() {
    cpu_set_t all, one;
    const int here = sched_getcpu();
    if (here < 0 || sched_getaffinity(0, sizeof all, &all) != 0) return;
    CPU_ZERO(&one);
    CPU_SET(here, &one);
    if (sched_setaffinity(0, sizeof one, &one) == 0) before = new Before{all};
}

OneProcessor::~OneProcessor() {
    if (before) sched_setaffinity(0, sizeof before->processors, &before->processors);
    delete before;
}

#else

struct OneProcessor::Before {};
OneProcessor::OneProcessor() = default;
OneProcessor::~OneProcessor() = default;

#endif

}  // namespace bench
