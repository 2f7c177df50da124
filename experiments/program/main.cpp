#include "experiments/program/command_line.hpp"

int main(int argc, char** argv) { return kappabench::run_command_line(argc, argv); }
