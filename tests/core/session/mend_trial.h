// Links that mend, each carried out and taken back in a session, by what the stages find of the
// model before and after from scratch.
#pragma once

#include "tests/core/session/staged.h"

#include <QString>

namespace fff::test {

/// What is wrong with what a link does to the document; empty if nothing is: it makes no verdict
/// worse, does what it is offered for, says beforehand what it does, and undo gives back the very
/// file.
QString faultOf(const Mend &mend, const Finding &finding, const Document &document,
                const Staged &before);

} // namespace fff::test
