// Must not compile: the core knows no window and no Qt. Built by a test that expects the failure.
#include <QtCore/QObject>
