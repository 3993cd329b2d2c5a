// The words that a person reads when something went wrong: the one place where an Error or a
// Warning becomes a sentence. Translated in the context "Error"; a phrase that a reader puts into
// Error::args to say what was expected is marked there with QT_TRANSLATE_NOOP("Error", …).
#pragma once

#include "core/base/result.h"

#include <QtCore/QString>

namespace fff::io {

/// "fish.txt:340: found "nan", expected a finite number". Without a place only the sentence.
QString errorText(const Error &error);
QString warningText(const Warning &warning);

/// The same without the place. Missing args make a shorter sentence, never one with gaps.
QString errorSentence(const Error &error);
QString warningSentence(const Warning &warning);

} // namespace fff::io
