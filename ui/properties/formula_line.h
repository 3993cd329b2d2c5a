// What lies over a number field while the expression is typed that its number follows: the field
// itself shows and steps numbers only.
#pragma once

#include <QLineEdit> // first: moc stumbles over some standard headers
#include <QStringList>

#include <functional>

namespace fff::ui {

class FormulaLine : public QLineEdit
{
    Q_OBJECT
public:
    /// takes  what was typed, on Enter and when the focus leaves: why it cannot; empty: it has
    /// names  what can be named in it, offered while one types
    FormulaLine(QWidget *field, std::function<QString(const QString &)> takes,
                std::function<QStringList()> names);

    /// Over all of the field, with the focus.
    void open(const QString &text);
    /// The field has another size.
    void fit();
    bool isOpen() const { return !isHidden(); }
    /// The field has the focus again, and shows its number.
    bool isClosing() const { return m_isClosing; }

Q_SIGNALS:
    void refused(const QString &reason);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void close();
    void showRefused(const QString &why);
    bool isTaken();
    /// Stays open where it is refused.
    void enter();

    QWidget *m_field;
    std::function<QString(const QString &)> m_takes;
    bool m_isClosing = false;
};

} // namespace fff::ui
