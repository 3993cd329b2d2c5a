// What goes to a workshop besides the sheets: the steps on paper; and the folder that has all of it
// where it is not packed.
#pragma once

#include "core/fabrication/layout.h"
#include "core/io/file_set.h"

#include <QString>

#include <memory>
#include <vector>

class QWidget;

namespace fff {
class Session;
}

namespace fff::ui {

/// A folder of its own for a model's files, beside them; it may not be there yet.
/// model  its path without a suffix, or that of such a folder
QString workshopFolder(const QString &model);
/// The same in one that a person chooses. Empty: none was chosen.
QString askForWorkshopFolder(QWidget *parent, const QString &suggestion);

/// The files in that folder, which is made where there is none: what comes of that is said when
/// they are written.
std::vector<io::NamedBytes> inWorkshopFolder(const QString &folder,
                                             std::vector<io::NamedBytes> files);

struct WorkshopSteps
{
    std::vector<io::NamedBytes> files; // "steps.pdf", or none
    QString whyNone;                   // a sentence
    bool isGivenUp = false;            // somebody does not want to wait for any of it
};

/// How the session's model goes together, on paper, in the window's words and lengths. Waits for
/// the order of assembly; the window shows how far it is.
/// doing  what is said meanwhile; title  the model's name; layout  of what is cut
WorkshopSteps workshopSteps(QWidget &window, const Session &session, const QString &doing,
                            const QString &title, std::shared_ptr<const Layout> layout);

} // namespace fff::ui
