// The bar under the tool bar: what went wrong, was mended or is on offer, in words, with what can
// be done about it as buttons, until it is closed. Never takes the focus by itself.
#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace fff::ui {

class MessageBar : public QFrame
{
    Q_OBJECT
public:
    enum class Severity { Info, Warning, Error };

    /// What can be done about it. Pressing it closes the message first.
    struct Verb
    {
        QString text;
        std::function<void()> act;
    };

    explicit MessageBar(QWidget *parent = nullptr);

    /// Replaces what is shown; without lines it is dismiss(). Several lines are several things; at
    /// most kMaxLines are shown, the last of them then says how many more there are. `details` is
    /// the technical text, which a button unfolds, at most kMaxDetails lines of it.
    void show(Severity severity, const QStringList &lines, std::vector<Verb> verbs = {},
              const QString &details = {});
    /// The same, but what is shown now may be read first: this follows when it is closed. It is an
    /// offer, which waits for its answer: it comes back when what was shown in its place is closed.
    void showNext(Severity severity, const QStringList &lines, std::vector<Verb> verbs);
    /// What was said is over, of an earlier file for example. An offer stays.
    void dismiss();
    /// The same without a change of what is said: in the colours of the theme.
    void refresh();
    QString text() const;
    QString details() const;

    static constexpr int kMaxLines = 4, kMaxDetails = 12;

private:
    static QString shortened(const QString &details);
    void close();
    void setVerbs(std::vector<Verb> verbs);

    std::vector<std::function<void()>> m_next; // show what waits, in this order
    std::function<void()> m_offer;             // shows what is shown; empty: it is none
    Severity m_severity = Severity::Warning;
    QLabel *m_icon = nullptr;
    QLabel *m_text = nullptr;
    QLabel *m_details = nullptr;
    QPushButton *m_unfold = nullptr;
    QToolButton *m_close = nullptr;
    QHBoxLayout *m_verbRow = nullptr;
    std::vector<QPushButton *> m_verbs;
};

} // namespace fff::ui
