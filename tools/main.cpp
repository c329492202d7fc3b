// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
int main() { return 1; }
