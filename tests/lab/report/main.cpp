#include <iostream>

#include "lab/report/reportProgram.h"

int main(int argc, char** argv) {
    return lab::reportProgram(std::vector<std::string>(argv + 1, argv + argc), std::cout,
                              std::cerr);
}
