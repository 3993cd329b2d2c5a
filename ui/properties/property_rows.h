// Rows of the Properties dock. Each knows a name, how to read its value from the session and, when
// it can be changed, how to make the edit; refresh() reads again. A widget is set only where its
// value differs.
#pragma once

#include "ui/properties/choice_box.h"
#include "ui/properties/length_edit.h"

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QToolButton;

namespace fff::ui {

/// A button with a picture only, beside a field.
QToolButton *smallButton(const QString &icon, const char *objectName, const QString &tip,
                         QWidget *parent);

class PropertyRow : public QWidget
{
public:
    virtual void refresh() = 0;
    /// A small button behind the editor.
    QToolButton *addButton(const QString &icon, const char *objectName, const QString &tip,
                           std::function<void()> act);

    /// For what it is of now. pattern: may have a place for `of`, which is cut short where it is
    /// long.
    void setName(const QString &pattern, const QString &of = {});
    /// Marked: a person has set it, in place of what it is by itself. tip: says so.
    void setMarked(bool marked, const QString &tip);
    /// The editor keeps its size and the name has the rest; cut short, its tip says all of it. For
    /// names that a person gives.
    void giveNameTheRest();
    /// Labels of rows that stand below one another, as wide as the widest, so that their editors
    /// begin at one line.
    static void alignLabels(const std::vector<PropertyRow *> &rows);

protected:
    void resizeEvent(QResizeEvent *event) override;
    PropertyRow(const QString &name, QWidget *parent);
    /// The editor has the label's place, too.
    void giveWholeRow();
    /// Where the editor needs more room than others; px.
    void narrowLabel(int width);
    /// The name stands above the editor where that, beside it, has not so much room, px.
    void setLeastRoom(int width);
    /// The editor takes the rest of the row; it is called as the row is.
    void setEditor(QWidget *editor, const char *objectName, bool fills);

private:
    void showName();
    void tellEditor();
    void placeName();

    QLabel *m_label = nullptr;
    QWidget *m_editor = nullptr;
    QString m_pattern, m_of; // its name
    bool m_isMarked = false;
    bool m_nameHasTheRest = false;
    int m_leastRoom = 0;
    bool m_isNameAbove = false;
};

/// Read only.
class TextRow : public PropertyRow
{
public:
    /// read  a null string when the selected things differ
    TextRow(const QString &name, const char *objectName, std::function<QString()> read,
            QWidget *parent = nullptr);
    void refresh() override;

private:
    QLabel *m_value = nullptr;
    std::function<QString()> m_read;
};

class LengthRow : public PropertyRow
{
public:
    /// read  nothing when the selected things differ
    LengthRow(const QString &name, const char *objectName, const LengthEdit::Range &range,
              std::function<std::optional<double>()> read, std::function<void(double)> write,
              QWidget *parent = nullptr);
    void refresh() override;
    void setFollowed(Followed followed) { m_edit->setFollowed(std::move(followed)); }
    /// What "t" stands for in it.
    void setThickness(LengthEdit::Thickness thickness)
    {
        m_edit->setThickness(std::move(thickness));
    }

private:
    LengthEdit *m_edit = nullptr;
    std::function<std::optional<double>()> m_read;
};

class ChoiceRow : public PropertyRow
{
public:
    ChoiceRow(const QString &name, const char *objectName, std::function<Choices()> read,
              std::function<void(int)> write, QWidget *parent = nullptr);
    void refresh() override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    ChoiceBox *m_box = nullptr;
    std::function<Choices()> m_read;
};

/// With an editor of its own kind, which announces changes by itself.
class EditorRow : public PropertyRow
{
public:
    /// editor  null: a row that shows nothing and only reads
    EditorRow(const QString &name, const char *objectName, QWidget *editor,
              std::function<void()> read, QWidget *parent = nullptr);
    void refresh() override;

private:
    std::function<void()> m_read;
};

/// A heading that folds the rows under it.
class PropertyGroup : public QWidget
{
public:
    /// Without a name it has no heading, and does not fold.
    explicit PropertyGroup(const QString &name, QWidget *parent = nullptr);
    void add(QWidget *row);
    void fold(bool folds = true);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    const QString m_name;
    QPushButton *m_title = nullptr;
    QWidget *m_rows = nullptr;
};

} // namespace fff::ui
