// What a reader found wrong. The first error is the one that counts: after it, readers go on with
// harmless values only as far as the end of the loop they are in.
#pragma once

#include "core/io/loaded_document.h"

#include <optional>

namespace fff::io {

struct Problems
{
    std::string file; // how places call the file; may be empty
    std::optional<Error> error = std::nullopt;
    std::vector<Warning> warnings = {};

    bool failed() const { return error.has_value(); }

    void fail(ErrorCode code, const std::string &where, std::vector<std::string> args = {})
    {
        if (!error)
            error = Error{code, placeIn(file, where), std::move(args)};
    }

    void warn(WarningCode code, const std::string &where, std::vector<std::string> args = {})
    {
        warnings.push_back({code, placeIn(file, where), std::move(args)});
    }
    /// Warnings that know where in the file, but not of which file.
    void warn(const std::vector<Warning> &placed)
    {
        for (const Warning &warning : placed)
            warn(warning.code, warning.place, warning.args);
    }
};

} // namespace fff::io
