# printf in blocks prints numbers as C would; a section with warnings tells what its depth cut off.
cat > print.lsys <<'END'
axiom: A(1)
Start: { printf("start %d%%\n", 7/2); n = 0; }
EndEach: { n = n + 1; printf("%3d: %5.2f|%-6g|%e\n", n, n/3, n*n, 1000*n); }
A(x) --> A(x+1)
END
lsysc interp print.lsys -n 2
cat > deep.lsys <<'END'
axiom: A(9)
A(x) --> A(x)
decomposition: warnings
maximum depth: 2
A(x) : x > 0 --> BA(x-1)
END
lsysc interp deep.lsys -n 2
