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

namespace fff::ui {

class PropertyRow : public QWidget
{
public:
    virtual void refresh() = 0;

protected:
    PropertyRow(const QString &name, QWidget *parent);
    /// The editor takes the rest of the row; it is called as the row is.
    void setEditor(QWidget *editor, const char *objectName, bool fills);

private:
    QLabel *m_label = nullptr;
};

/// Read only.
class TextRow : public PropertyRow
{
public:
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

private:
    ChoiceBox *m_box = nullptr;
    std::function<Choices()> m_read;
};

/// A heading that folds the rows under it.
class PropertyGroup : public QWidget
{
public:
    explicit PropertyGroup(const QString &name, QWidget *parent = nullptr);
    void add(PropertyRow *row);

private:
    QPushButton *m_title = nullptr;
    QWidget *m_rows = nullptr;
};

} // namespace fff::ui
