// A field for a number with a unit behind it, or for a sum of numbers. Says a new value once when
// it is done: on Enter, when the focus leaves, or a moment after the last step of its arrows. What
// it cannot take it refuses with a reason, beside it: on Enter it stays there to be mended, and
// when the focus leaves the value before it comes back.
//
// Where its number can follow an expression (Followed), a small ƒ says that it does; with the focus
// the expression lies over it to be changed, and a plain number ends it.
#pragma once

#include <QDoubleSpinBox> // first: moc stumbles over some standard headers
#include <QTimer>

#include "core/base/expression.h"
#include "ui/properties/followed.h"

#include <optional>

class QLabel;

namespace fff::ui {

class FormulaLine;

class NumberEdit : public QDoubleSpinBox
{
    Q_OBJECT
public:
    struct Range
    {
        double least = 0.0, most = 0.0, step = 0.1;
        int digits = 2;     // shown of every value
        int mostDigits = 2; // shown where they are not zero
    };

    /// unit  its sign, behind the number; may be empty
    NumberEdit(const Range &range, const QString &unit, QWidget *parent = nullptr);

    /// For several beside each other: narrow, without arrows and unit.
    void setCompact();

    /// What it takes to show this number with its unit, px.
    int widthFor(const QString &number) const;

    /// Shows a value without announcing it; nothing: the selected things differ. Leaves the field
    /// alone while a person is typing in it.
    void setNumber(std::optional<double> number);

    /// "=" begins an expression in it, and so does the name of a value.
    void setFollowed(Followed followed);
    bool follows() const;
    bool isTypingFormula() const;
    /// What stands over the number then.
    QString formulaTyped() const;

    /// What stands in the field while it is typed, if it is a value of it.
    std::optional<double> typed() const;
    /// Why what stands in the field is no value of it; empty when it is one.
    QString refusal() const;

Q_SIGNALS:
    void numberEdited(double number);
    void refused(const QString &reason);

protected:
    /// What stands in the field, without its unit, as a number of the range.
    virtual Expression read(const QString &text) const;
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *object, QEvent *event) override;

    const Range &range() const { return m_range; }
    void setUnit(const QString &sign, double step);
    /// Without the unit; the digits that are shown stand for all that the value has.
    bool showsValue(const QString &text) const;

private:
    void announce();
    void takeBack();
    void showNothing();
    bool isSpecial(const QString &text) const;
    Expression readWithUnit(const QString &text) const;
    /// Of an expression that was read: why its number is none of the field; empty when it is.
    QString whyNot(const Expression &typed) const;
    void refuse(const QString &reason);
    // Of what it follows: number_edit_followed.cpp.
    void openFormula(const QString &typed);
    void showExpression();
    bool takesKey(QKeyEvent *event);
    void followNames(const QString &text);
    bool isFormula(const QString &typed) const;
    QString take(const QString &typed);
    QString takeNumber(const Expression &number);
    void showMark();

    Range m_range;
    QString m_suffix;              // the unit behind every number
    bool m_isCompact = false;      // it is not shown
    std::optional<double> m_shown; // what the field held when last set from outside, or announced
    QTimer m_settled;
    bool m_isSetting = false;
    Followed m_followed;
    FormulaLine *m_formula = nullptr; // where it can follow
    QLabel *m_mark = nullptr;         // ƒ
};

} // namespace fff::ui
