#include "tests/test_program.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace fff::testing {

namespace {

std::map<std::string, Run> &tests()
{
    static std::map<std::string, Run> all;
    return all;
}

} // namespace

Registered::Registered(const char *file, Run run)
{
    tests().emplace(std::filesystem::path(file).stem().string(), run);
}

} // namespace fff::testing

int main(int argc, char *argv[])
{
    const auto &tests = fff::testing::tests();
    const auto test = argc > 1 ? tests.find(argv[1]) : tests.end();
    if (test == tests.end()) {
        std::fprintf(stderr, "%s: give one of its tests, then options of Qt Test:\n", argv[0]);
        for (const auto &[name, run] : tests)
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    // The test sees the command line as if it were a program by itself.
    argv[1] = argv[0];
    return test->second(argc - 1, argv + 1);
}
