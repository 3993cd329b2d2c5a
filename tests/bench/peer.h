// Timings of the old program, from a table in Markdown.
#pragma once

#include "core/base/result.h"

#include <QString>

#include <map>
#include <string>
#include <vector>

namespace fff::bench {

/// The columns that both programs have; milliseconds.
struct PeerRow
{
    double load = 0.0, slits = 0.0, svg = 0.0, drag = 0.0, physics = 0.0;
};

/// By the name of the model, blanks and case aside: "comb of 50", "lattice 25 × 25".
struct Peer
{
    double kernel = 0.0; // ms, on the machine that the rows are from
    std::map<std::string, PeerRow> rows;

    const PeerRow *find(const std::string &name) const;
};

/// Errors  CannotOpen, BadSyntax when there is no table with these columns or no kernel's time.
Result<Peer> readPeer(const QString &path);

} // namespace fff::bench
