// The group "Marks" of the Properties dock: what is drawn on the selected section to be engraved or
// scored, and the words in it.
#pragma once

#include "ui/properties/varying_rows.h"

#include "core/model/section.h"

class QPlainTextEdit;

namespace fff::ui {

class Workbench;

class MarkGroup : public PropertyGroup
{
public:
    explicit MarkGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden unless one section is selected that has marks.
    void refresh();

private:
    void rebuild(const Section &section);
    void addMark(std::size_t index, const Mark &mark);
    void addWords(std::size_t index);
    Followed followedOf(std::size_t index, const char *field) const;
    void addNumber(std::size_t index, const QString &name, const char *key,
                   const LengthEdit::Range &range, double (*read)(const Lettering &),
                   void (*write)(Lettering &, double));
    void addTurn(std::size_t index);

    /// The drawn section; null: there is not one.
    const Section *section() const;
    const Mark *mark(std::size_t index) const;
    void change(std::size_t index, const std::function<void(Lettering &)> &change);
    void run(const char *command, std::size_t index) const;

    Workbench &m_bench;
    VaryingRows m_rows;
    SectionId m_of; // the section as of the last look, and how many marks it had
    std::size_t m_count = 0;
    QPlainTextEdit *m_words = nullptr; // of its last mark; null where that has none
};

} // namespace fff::ui
