#include "ui/files/replace_question.h"

#include "core/io/listing.h"
#include "ui/base/theme.h"
#include "ui/dialogs/export_place_row.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace fff::ui {

namespace {

struct ReplaceQuestionTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ReplaceQuestion)
};

/// More names than this are no help.
constexpr qsizetype kMostNames = 8;

} // namespace

bool mayReplace(QWidget &window, const std::vector<io::NamedBytes> &files)
{
    QStringList there;
    for (const io::NamedBytes &file : files) {
        // Of a folder is said that it is one; a link may lead to where nothing is yet.
        if (const QFileInfo info(file.path); info.isFile() || (info.isSymLink() && !info.exists()))
            there += QFileInfo(file.path).fileName();
    }
    if (there.isEmpty())
        return true;
    QMessageBox question(QMessageBox::NoIcon, ReplaceQuestionTexts::tr("Replace files"),
                         there.size() == 1
                             ? ReplaceQuestionTexts::tr("Replace this file?")
                             : ReplaceQuestionTexts::tr("Replace %n existing file(s)?", nullptr,
                                                        static_cast<int>(there.size())),
                         QMessageBox::NoButton, &window);
    question.setObjectName(QStringLiteral("replaceQuestion"));
    QStringList named = there.mid(0, kMostNames);
    if (named.size() < there.size())
        named += QStringLiteral("…");
    question.setInformativeText(
        ExportPlaceRow::placeText(separated(named), QFileInfo(files.front().path).absoluteDir()));
    QPushButton *replace =
        question.addButton(ReplaceQuestionTexts::tr("Replace"), QMessageBox::AcceptRole);
    QPushButton *back =
        question.addButton(ReplaceQuestionTexts::tr("Cancel"), QMessageBox::RejectRole);
    question.setDefaultButton(back); // what is there may be somebody’s
    question.setEscapeButton(back);
    dress(&question);
    question.exec();
    return question.clickedButton() == replace;
}

} // namespace fff::ui
