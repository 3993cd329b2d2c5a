// Documents hold what a person asked for; evaluation makes the sections that follow from it.
#pragma once

#include "core/model/model.h"

namespace fff {

/// The model of a document: its numbers become what was typed for them (driven.h), and then its
/// operations work one after the other, each on the drawn sections and
/// on what those above it made. One that would see all that it looked at as in `previous` is not
/// done again; of what is done again, sections and shapes that come out as they were are the very
/// objects of `previous`, so that all that is derived from them is kept. Pure; safe on any thread.
Model evaluate(Document document, const Model &previous = {});

} // namespace fff
