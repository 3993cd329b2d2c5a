// One of a few choices, all of them in sight, as buttons that stand close together.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include <QStringList>

class QButtonGroup;

namespace fff::ui {

class SegmentedBox : public QWidget
{
    Q_OBJECT
public:
    SegmentedBox(const QStringList &texts, QWidget *parent = nullptr);

    /// Announces nothing; −1: none is chosen.
    void setCurrent(int index);
    int current() const;
    void setText(int index, const QString &text);
    /// What is read out of each button, before its text.
    void setSpoken(const QString &name);

    /// What the texts take in the window's font, px.
    static int widthOf(const QStringList &texts, const QFont &font);

Q_SIGNALS:
    void activated(int index);

private:
    QButtonGroup *m_buttons = nullptr;
};

} // namespace fff::ui
