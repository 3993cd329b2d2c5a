// One line of words of which some are bold (<b>…</b>) or keys to press (<kbd>…</kbd>). Too long for
// its place, it is cut short and says the whole in its tooltip. text() is the sentence without
// marks.
#pragma once

#include <QLabel>

#include <vector>

namespace fff::ui {

class SentenceLabel : public QLabel
{
public:
    explicit SentenceLabel(QWidget *parent = nullptr);

    /// Marked text; what comes from outside must be escaped (QString::toHtmlEscaped).
    void setSentence(const QString &marked);
    bool isCutShort() const;

    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    enum class Kind { Plain, Bold, Key };
    struct Run
    {
        QString text;
        Kind kind = Kind::Plain;
    };

    QFont fontOf(Kind kind) const;
    int widthOf(const Run &run) const;
    void refreshTip();

    std::vector<Run> m_runs;
};

} // namespace fff::ui
