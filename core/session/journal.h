// What happened to the document, one line each, for whoever looks into it afterwards:
// QT_LOGGING_RULES="flatfitfab.journal.debug=true" writes it to standard error. Off, it costs
// nothing.
//
//     opened D, step D     the session's document is D now (a digest of its file)
//     saving D, saved D    it is being written to the person's file; it is there
//     kept D, cleared      it is in the recovery folder (core/session/autosave.h); nothing is
#pragma once

#include "core/model/document.h"

#include <QByteArray>
#include <QLoggingCategory>

namespace fff {

Q_DECLARE_LOGGING_CATEGORY(journal)

/// Same for the same document, read from a file or not.
QByteArray digestOf(const Document &document);

} // namespace fff
