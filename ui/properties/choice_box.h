// A box to choose one of several things, each with a chip in its colour.
#pragma once

#include <QColor>
#include <QComboBox>
#include <QIcon>

#include <vector>

namespace fff::ui {

struct Choice
{
    QString text;
    QColor colour;       // invalid: no chip
    QString whyNot = {}; // not empty: it cannot be chosen
    bool operator==(const Choice &) const = default;
};

struct Choices
{
    std::vector<Choice> all;
    int current = -1; // -1: the selected things differ
};

/// A small square of that colour, at 1x, 2x and 3x.
QIcon colourChip(const QColor &colour);

class ChoiceBox : public QComboBox
{
public:
    explicit ChoiceBox(QWidget *parent = nullptr);

    /// Changes only what differs from what is shown; announces nothing.
    void setChoices(const Choices &choices);

    /// In the colours of the theme, which are the window's, not those of a list that opens over it.
    QSize sizeHint() const override;
    void showPopup() override;
    /// In which all of what is chosen can be read, px.
    int widthForShown() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    QString shownText(const QStyleOptionComboBox &option) const;

    std::vector<Choice> m_shown;
};

} // namespace fff::ui
