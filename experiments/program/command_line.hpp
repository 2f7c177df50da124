#pragma once

namespace kappabench {

/// The program `kappabench`: parses the arguments and runs one verb. Returns the exit status: 0 success, 2 usage or
/// input error, 3 a fit or an experiment ran and failed. Never throws; errors are one line on stderr.
int run_command_line(int argc, char** argv);

}  // namespace kappabench
