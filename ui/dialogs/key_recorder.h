// A field that takes the next keys that are pressed together, instead of what they do.
#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace fff::ui {

class KeyRecorder : public QLineEdit
{
    Q_OBJECT
public:
    explicit KeyRecorder(QWidget *parent = nullptr);

    void setKeys(const QKeySequence &keys);

Q_SIGNALS:
    /// Tab, Enter and Esc are not recorded: they lead out of the field and of the dialog.
    void recorded(const QKeySequence &keys);

protected:
    bool event(QEvent *event) override;

private:
    bool take(const QKeyEvent &event);
};

} // namespace fff::ui
