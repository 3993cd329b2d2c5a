// What a reader of models may be told.
#pragma once

#include "core/base/long_work.h"
#include "core/io/blobs.h"
#include "core/model/naming.h"

#include <map>
#include <string>

namespace fff::io {

/// Values of a format's options (core/io/formats.h) by name; what is missing is as usual.
using FormatValues = std::map<std::string, double>;
/// That of an option, or what is usual.
inline double valueOf(const FormatValues &values, const char *option, double usual)
{
    const auto found = values.find(option);
    return found == values.end() ? usual : found->second;
}

struct ReadOptions
{
    std::string name;   // how errors call the file; empty: the path as it was given
    Naming naming = {}; // of sections that have no names in the file
    FormatValues values = {};
    BlobSource blobs = {}; // of a model whose file names some without having them
    LongWork work = {};    // of meshes that are in it
};

} // namespace fff::io
