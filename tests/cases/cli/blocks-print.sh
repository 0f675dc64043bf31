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
lsysc run deep.lsys -n 2
lsysc run deep.lsys -n 2 --quiet
cat > shown.lsys <<'FILE'
axiom: CA(1)[A(2)]
A(x) --> A(x)A(x+1)
homomorphism: warnings
maximum depth: 3
C < A(x) : x < 3 --> FA(x)
A(x) : { y = x; } y > 100 --> F
FILE
lsysc run shown.lsys -n 1 --homomorphism --threads 2
lsysc interp shown.lsys -n 1 --homomorphism
cat > enough.lsys <<'FILE'
axiom: A(1)
A(x) --> A(x)A(x+1)
decomposition: warnings
maximum depth: 3
A(x) : x > 1 --> B
FILE
lsysc run enough.lsys -n 3 && lsysc interp enough.lsys -n 3
