// The bar under the tool bar: what went wrong or was mended, in words, until it is closed. Never
// takes the focus.
#pragma once

#include <QFrame>

class QLabel;

namespace fff::ui {

class MessageBar : public QFrame
{
    Q_OBJECT
public:
    enum class Severity { Warning, Error };

    explicit MessageBar(QWidget *parent = nullptr);

    /// Replaces what is shown. Several lines are several things; at most kMaxLines are shown, the
    /// last of them then says how many more there are.
    void show(Severity severity, const QStringList &lines);
    /// The same without a change of what is said: in the colours of the theme.
    void refresh();
    QString text() const;

    static constexpr int kMaxLines = 4;

private:
    Severity m_severity = Severity::Warning;
    QLabel *m_icon = nullptr;
    QLabel *m_text = nullptr;
};

} // namespace fff::ui
