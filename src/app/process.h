#pragma once

/// Prepares the process for outputs that cannot be written, before any file is opened.
void prepareProcess();
