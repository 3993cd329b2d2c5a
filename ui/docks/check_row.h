// One verdict in the Checks dock: glyph, title, one sentence, and what can be done at once.
#pragma once

#include <QAbstractButton>
#include <QStringList>

class QLabel;

namespace fff::ui {

class LinkRow;

class CheckRow : public QAbstractButton
{
    Q_OBJECT
public:
    struct Content
    {
        QString glyph; // name of an icon
        QColor colour;
        QString kind;   // "Problem", for those who hear it
        int number = 0; // of a problem, before its title; 0: none
        QString title, text;
        QStringList links; // what can be done at once
        bool isOlder = false;
        bool operator==(const Content &) const = default;
    };

    explicit CheckRow(QWidget *parent = nullptr);

    /// Changes only what differs.
    void setContent(const Content &content);
    void refresh(); // in the colours of the theme
    /// As if the cursor were on it: it is on its mark in the view.
    void setLit(bool lit);

    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

Q_SIGNALS:
    void linkClicked(int index, bool isByKey);
    void linkHovered(int index, bool isOver);
    void hovered(bool isOver);

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void moveEvent(QMoveEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    Content m_content;
    bool m_isLit = false;
    bool m_isPressed = false; // last by a press on what it is now, and where it is
    QLabel *m_glyph = nullptr, *m_title = nullptr, *m_text = nullptr;
    LinkRow *m_links = nullptr;
};

} // namespace fff::ui
