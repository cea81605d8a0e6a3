// Ctrl-C stops the work between two steps, so that nothing half-written stays behind.
#pragma once

namespace umbra {

// From here on SIGINT and SIGTERM ask for a stop instead of ending the process.
void catchInterrupts();

// Throws Cancelled once a stop was asked for. Call between the steps of long work.
void throwIfCancelled();

}  // namespace umbra
