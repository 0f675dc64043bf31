# Blocks read and write files: in any engine, in productions in the order of the word, and in cpfg's notation.
printf '3 0.5\n7e1' > numbers.txt
cat > files.lsys <<'FILE'
Start: {
  in = fopen("numbers.txt", "r");
  out = fopen("out.txt", "w");
  fscanf(in, "%f %f", a, b);
  c = fscanf(in);
  end = fscanf(in);
  fclose(in);
  fprintf(out, "start %g %g %g%%\n", a, b, c);
}
End: { fprintf(out, "end\n"); fclose(out); }
axiom: A(a)A(b)A(c)E(end)
A(x) : { fprintf(out, "%g ", x); } 1 --> A(x+1)
EndEach: { fprintf(out, "\n"); }
steps: 2
FILE
for how in interp run; do
  lsysc $how -w files.lsys && cat out.txt && rm out.txt
done
lsysc -w files.lsys -o files && ./files --quiet -o picture.svg && cat out.txt && ls
lsysc fmt files.lsys | sed -n 4,5p
cat > files.l <<'FILE'
Lsystem: 1
derivation length: 1
define: { array v[2]; }
Start: { f = fopen("numbers.txt","r"); fscanf(f,"%f%lf",&v[0],&y); fclose(f); }
Axiom: A
A --> B(v[0],y)
endlsystem
FILE
lsysc run -w files.l
cat > wrong.lsys <<'FILE'
Start: {
  f = fopen("a.txt", "rw");
  g = 1 + fopen("a.txt", "r");
  fprintf(f, "%g\n");
  fprintf("a %g\n", 1);
  fscanf(f, "%s", n);
  n = fscanf(f, 1);
  fopen("a", "r");
}
axiom: A(fscanf(1))
FILE
lsysc check wrong.lsys
printf 'Start: { f = fopen("none.txt", "r"); }\naxiom: A\nA --> A\n' | lsysc run - -n 1
printf 'Start: { f = fopen("/", "r"); }\naxiom: A\nA --> A\n' | lsysc run - -n 1
printf 'Start: { f = fopen("/dev/full", "w"); fprintf(f, "1"); }\naxiom: A\nA --> A\n' > full.lsys
lsysc run full.lsys -n 1 -o full.svg || echo "ends with $?"
test -e full.svg || echo 'and without a picture'
printf 'Start: { fclose(3); }\naxiom: A\nA --> A\n' | lsysc interp - -n 1
printf 'StartEach: { f = fopen("/dev/null", "r"); }\naxiom: A\nA --> A\n' | lsysc run - -n 50
lsysc check /dev/zero
