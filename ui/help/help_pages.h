// The pages of the help, in the window's language where they are there in it, and which of them
// tells about what is under the cursor. Pages are resources/help/NAME.md.
#pragma once

#include <QString>
#include <QStringList>
#include <QUrl>

#include <string_view>

class QWidget;

namespace fff::ui {

/// A place in the help.
struct HelpTopic
{
    QString page;     // "operations"
    int heading = -1; // which of its second-level headings, from 0 on; −1: its beginning
    bool operator==(const HelpTopic &) const = default;
};

/// What a list of all keys is called among them; it has no file.
inline const QString kKeysPage = QStringLiteral("keys");

/// Names, in the order in which they are read.
const QStringList &helpPages();
/// Of one that has a file.
QUrl helpAddress(const QString &page);
/// Its first line, and its headings of the second level: plain text.
QString helpTitle(const QString &page);
QStringList helpHeadings(const QString &page);

/// About a command, by its id; the first page where none tells about it.
HelpTopic topicOf(std::string_view command);
/// About what a widget, or one that it lies in, is for: the command of a button, or that part of
/// the window.
HelpTopic topicAt(const QWidget *widget);

} // namespace fff::ui
