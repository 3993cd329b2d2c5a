// How the view shows something else than the model as it is, as chips under the verdicts: "X-ray",
// "Cut open", "Skin" and how far that has come. A click on one switches it off. Widgets of their
// own, as the verdicts are.
#pragma once

#include <QAbstractButton> // first: moc stumbles over some standard headers

namespace fff::ui {

class Workbench;

/// Its words and a cross.
class ViewChip : public QAbstractButton
{
    Q_OBJECT
public:
    ViewChip(const QString &text, const QString &tip, QWidget *parent);

    /// Other words than before.
    void say(const QString &text, const QString &tip);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QFont words() const;
};

class ViewChips : public QWidget
{
    Q_OBJECT
public:
    /// Stands over `view`, so far below its upper edge, px.
    ViewChips(Workbench &bench, QWidget *view, int top);

    /// In the colours of the theme.
    void refreshColours();

private:
    void refresh();

    Workbench &m_bench;
    ViewChip *m_xray = nullptr, *m_cut = nullptr, *m_skin = nullptr;
};

} // namespace fff::ui
