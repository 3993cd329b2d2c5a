// A box to choose one of several things, each with a chip in its colour.
#pragma once

#include <QColor>
#include <QComboBox>

#include <vector>

namespace fff::ui {

struct Choice
{
    QString text;
    QColor colour;
    bool operator==(const Choice &) const = default;
};

struct Choices
{
    std::vector<Choice> all;
    int current = -1; // -1: the selected things differ
};

class ChoiceBox : public QComboBox
{
public:
    explicit ChoiceBox(QWidget *parent = nullptr);

    /// Changes only what differs from what is shown; announces nothing.
    void setChoices(const Choices &choices);

protected:
    void wheelEvent(QWheelEvent *event) override;

private:
    std::vector<Choice> m_shown;
};

} // namespace fff::ui
