// Names that complete while an expression is typed: behind "=", in a list under the field.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include <QStringList>

#include <functional>

class QCompleter;
class QKeyEvent;
class QLineEdit;
class QStringListModel;

namespace fff::ui {

class NameCompletion : public QObject
{
    Q_OBJECT
public:
    enum class Where { Everywhere, BehindEquals };
    NameCompletion(QLineEdit *line, Where where, std::function<QStringList()> names);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    /// A key of the list while it is open: Enter and Tab take the name that is chosen in it, Esc
    /// closes it. False: it is the line's.
    bool takes(const QKeyEvent &event);
    bool isOpen() const;
    void makeList();
    void offer();
    void complete(const QString &name);

    QLineEdit *m_line;
    Where m_where;
    QCompleter *m_list = nullptr; // once there was something to complete
    QStringListModel *m_model = nullptr;
    std::function<QStringList()> m_names;
    qsizetype m_wordBegin = 0; // of the word that is being typed
};

} // namespace fff::ui
