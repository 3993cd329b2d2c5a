// A frame in the accent's colour round whatever has the focus, for as long as the person works with
// keys: most widgets hardly show it by themselves.
#pragma once

#include <QObject>

class QApplication;
class QFocusFrame;

namespace fff::ui {

class FocusFrame : public QObject
{
    Q_OBJECT
public:
    /// For all windows of the program. FieldStyle draws it.
    explicit FocusFrame(QApplication &application);
    ~FocusFrame() override;

    /// A widget that shows its focus by itself, on all of its edge.
    static void leaveTo(QWidget *widget);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void show(QWidget *widget);

    QFocusFrame *m_frame = nullptr; // made when it is first needed
    bool m_usesKeys = false;        // since the last press of a mouse button
};

} // namespace fff::ui
