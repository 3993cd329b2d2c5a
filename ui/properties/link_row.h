// What can be done, as links in a row that breaks where it is too narrow: "Move it to Body · Delete
// it". Each is a button of its own, to be reached with Tab and heard by its name.
#pragma once

#include <QStringList>
#include <QWidget>

#include <vector>

class QAbstractButton;

namespace fff::ui {

class LinkRow : public QWidget
{
    Q_OBJECT
public:
    /// px, round the words of a link, for the frame of the focus.
    static constexpr int kAround = 2;

    explicit LinkRow(QWidget *parent = nullptr);

    /// Changes only what differs.
    void setTexts(const QStringList &texts);
    const QStringList &texts() const { return m_texts; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

Q_SIGNALS:
    /// isByKey: not with the mouse.
    void clicked(int index, bool isByKey);
    /// The cursor or the focus came to it, or left it (isOver: false).
    void hovered(int index, bool isOver);

protected:
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    /// Where each goes in this width.
    std::vector<QRect> places(int width) const;
    void place();

    QStringList m_texts;
    std::vector<QAbstractButton *> m_links; // as many as texts, or more, hidden
};

} // namespace fff::ui
