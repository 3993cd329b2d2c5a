// Says in the message bar when an operation comes to make nothing, or stops short, by what was done
// last: what is missing, and what can be done about it.
#pragma once

#include <QObject>

#include "core/model/model.h"

#include <map>
#include <vector>

namespace fff::ui {

class MessageBar;
class Workbench;

class OperationNotices : public QObject
{
    Q_OBJECT
public:
    OperationNotices(Workbench &bench, MessageBar &messages, QObject *parent);

private:
    void follow();
    void tell(const Operation &operation, const OperationNotice &notice);

    Workbench &m_bench;
    MessageBar &m_messages;
    std::map<std::int64_t, std::vector<OperationNotice>> m_known; // by the operation's id
    QString m_told;                                               // what the bar shows of it
    bool m_isAnother = false;                                     // document: it is shown, not done
};

} // namespace fff::ui
