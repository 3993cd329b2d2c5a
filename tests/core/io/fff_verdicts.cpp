// Reads documents, one a line, and says of each what the reader says: "ok", or the code's number,
// the place and what was expected, with tabs between. For tests/core/io/check_schema.py.
#include "core/io/fff_format.h"

#include <cstdio>
#include <iostream>

int main()
{
    for (std::string line; std::getline(std::cin, line);) {
        const auto loaded = fff::io::readFff(line);
        if (loaded) {
            std::puts("ok");
            continue;
        }
        const fff::Error &error = loaded.error();
        const std::string expected = error.args.size() > 1 ? error.args[1] : std::string();
        std::printf("%s\t%s\t%s\n", error.code == fff::ErrorCode::BadValue ? "value" : "other",
                    error.place.c_str(), expected.c_str());
    }
    return 0;
}
