// SPDX-License-Identifier: BSD-3-Clause
// Being written.
int main() { return 0; }
