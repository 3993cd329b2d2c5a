// The status bar: at the left what the next gesture does, at the right what the model is.
#pragma once

#include <QStatusBar>
#include <QTimer>

class QLabel;

namespace fff::ui {

class Workbench;

class StatusLine : public QStatusBar
{
    Q_OBJECT
public:
    explicit StatusLine(Workbench &bench, QWidget *parent = nullptr);

    /// Says what was done, for some seconds or until the next press.
    void say(const QString &sentence);
    /// In the colours of the theme.
    void refresh();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void showHint();
    void showSentence(const QString &richText, bool isRefusal);
    void showNumbers();
    QLabel *addField(const char *objectName, const QString &name);

    Workbench &m_bench;
    QLabel *m_glyph = nullptr;
    QLabel *m_sentence = nullptr;
    QLabel *m_count = nullptr, *m_size = nullptr, *m_mass = nullptr;
    QTimer m_held; // a refusal or an answer stays while it runs
    bool m_isRefusal = false;
};

} // namespace fff::ui
