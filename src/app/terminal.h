#pragma once

bool stderrIsTerminal();

/// How many characters fit into a line of the terminal that is stderr; 80 if it does not say.
int terminalWidth();
