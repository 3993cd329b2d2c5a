// Which file Export writes, asked in two steps: what it is for, then in which format. What has a
// file for each sheet is a box to check.
#pragma once

#include "ui/dialogs/question_row.h" // first: moc stumbles over some standard headers

#include "ui/dialogs/export_choices.h"

#include <vector>

class QCheckBox;

namespace fff::ui {

class ChoiceBox;

class FileQuestion : public QuestionRow
{
    Q_OBJECT
public:
    /// files   at least one
    /// chosen  keys, the newest first; what there is not (any more) is passed over
    FileQuestion(std::vector<ExportFile> files, const QStringList &chosen,
                 QWidget *parent = nullptr);

    const ExportFile &file() const { return m_files[m_file]; }
    /// As they are given, the file first.
    QStringList chosen() const;

Q_SIGNALS:
    void fileChanged();

private:
    void refresh();
    void choose(std::size_t file);
    void chooseUse(int choice);
    std::vector<io::FileUse> uses() const;
    /// Of the use that is chosen, each with all sheets.
    std::vector<std::size_t> ways() const;
    /// The same with a file for each sheet, or with all of them; itself where there is none.
    std::size_t otherOf(std::size_t file) const;

    std::vector<ExportFile> m_files;
    std::size_t m_file = 0;
    QStringList m_chosen; // one of each use at most
    ChoiceBox *m_useBox = nullptr, *m_wayBox = nullptr;
    QCheckBox *m_perSheet = nullptr;
};

} // namespace fff::ui
