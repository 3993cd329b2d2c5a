// What is wrong with what is selected, above its numbers: on the colour of how bad it is, with its
// glyph.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/analysis/finding.h"

class QLabel;

namespace fff::ui {

class ProblemBox : public QWidget
{
    Q_OBJECT
public:
    /// labelName: object name of its text.
    ProblemBox(const char *labelName, QWidget *parent);

    /// Shows it; `html` may have links. Also for another theme.
    void tell(Severity severity, const QString &html);

Q_SIGNALS:
    void linkActivated(const QString &target);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    Severity m_severity = Severity::Warning;
    QLabel *m_glyph = nullptr;
    QLabel *m_text = nullptr;
};

/// As a link in its text, in the theme's colour.
QString linkTo(const QString &name, const QString &target);

} // namespace fff::ui
