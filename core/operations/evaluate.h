// Documents hold what a person asked for; evaluation makes the sections that follow from it.
#pragma once

#include "core/model/model.h"

namespace fff {

/// The model of a document. Sections whose operation has equal inputs in `previous` are the very
/// objects of `previous`, so that everything derived from them is kept. Pure; safe on any thread.
/// No kind of operation exists yet, so nothing is generated: each will be one file in this folder.
Model evaluate(Document document, const Model &previous = {});

} // namespace fff
