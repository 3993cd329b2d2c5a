// The status bar: at the left what the next gesture does, at the right what the model is.
#pragma once

#include <QStatusBar>
#include <QTimer>

#include <functional>

class QLabel;
class QToolButton;

namespace fff::ui {

class SentenceLabel;
class Workbench;

class StatusLine : public QStatusBar
{
    Q_OBJECT
public:
    /// Which keys an action has, for sentences that speak of them; empty: none now.
    using KeysOf = std::function<QString(const char *action)>;
    StatusLine(Workbench &bench, KeysOf keysOf, QWidget *parent = nullptr);

    /// Says what was done, for some seconds or until the next press. No marks in it.
    void say(const QString &sentence);
    /// The same with marks (ui/sentence_label.h). Empty: what was said last is over.
    void sayMarked(const QString &sentence);
    /// What the history did: "Undid “Draw Rib 3”. Ctrl+Shift+Z brings it back."
    void sayUndone(const QString &step);
    void sayRedone(const QString &step);
    /// Said in the place of hints as long as it is not empty: there is no view to give any.
    void setStanding(const QString &sentence);
    /// Said in the place of hints of the view as long as the hand is elsewhere; with marks.
    void setElsewhere(const QString &marked);
    /// In the colours of the theme.
    void refresh();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeUnits();
    void showHint();
    void showSentence(const QString &marked, bool isRefusal);
    void endSaid();
    void showNumbers();
    void showFields();
    QLabel *addField(const char *objectName, const QString &name);

    Workbench &m_bench;
    KeysOf m_keysOf;
    QLabel *m_glyph = nullptr;
    SentenceLabel *m_sentence = nullptr;
    QLabel *m_count = nullptr, *m_size = nullptr, *m_mass = nullptr;
    QToolButton *m_units = nullptr;
    QString m_standing, m_elsewhere;
    QTimer m_held; // a refusal or an answer stays while it runs
    bool m_isRefusal = false;
    bool m_isOfHistory = false;       // until the next change
    const void *m_saidWith = nullptr; // the tool that was in the hand then
};

} // namespace fff::ui
