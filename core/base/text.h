// Marks a text of this room for translation; the window and the command line translate it. Qt's own
// macro of this name does the same, but core knows no Qt.
#pragma once

#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(context, text) text
#endif
