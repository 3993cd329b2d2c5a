// Models of any size, made by rule: combs and egg crates.
#pragma once

#include "core/model/document.h"

#include <string>

namespace fff::bench {

/// A spine of `sections` − 1 ribs that stand across it, 10 mm apart: as many joints as ribs.
Document comb(int sections);
/// The same on a spine with corners at every tenth rib, which hang on its upper edge: a point that
/// is moved changes what is near it.
Document jointedComb(int sections);

/// n × n strips across each other, 20 mm apart: 2n sections, n² joints.
Document lattice(int n);

/// Many egg crates side by side, as one: n × n strips that each meet `reach` others at most,
/// so that a section has the same neighbours whatever n is. n is a multiple of `reach`.
Document crates(int n, int reach);

/// The lattice and one short section more (the last) that meets two neighbouring strips.
Document latticeWithShort(int n);

/// A curved spine and a rib that an operation of this kind ("linear", "revolve") repeats: 50
/// replicas, drawn sections are the spine (0) and the rib (1). scaled: each by the local thickness;
/// branches: the rib carries two more sections, which go along.
Document repeated(const char *kind, bool scaled, bool branches);

/// In the text format of FlatFab, which the old program's timings were taken on. Straight edges
/// and sections without holes only.
std::string flatfabText(const Document &document);

} // namespace fff::bench
