<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>ひとまとめの部品 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1（部品 %2）</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1（手順 %2 で一体になったもの）</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>ほか %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>上へ</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>下へ</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>右へ</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>左へ</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>手前へ</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>奥へ</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>矢印の方向へ</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>まだ板がないので、手順もありません。</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>このモデルから切り出すものがないので、手順もありません。</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>表示できる手順がありません: %1。</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>表示できる手順がありません: 時間内に組み立て順が見つかりませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>表示できる手順がありません: %n 枚の板がぶつかり合い、モデルを組み立てられません。</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>表示できる手順がありません: %1 の部品がぶつかり合い、モデルを組み立てられません。</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>表示できる手順がありません: %1 がぶつかり合い、モデルを組み立てられません。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>手順 %1/%2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>%1 から始める</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>%1 から別のまとまりを作り始める</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>%1 を所定の位置に置く</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>%1 を角から回し込み、最後は%2動かす</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>%1 を角から回し込み、%2スライドして %3 に差し込む</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>%1 を%2動かして所定の位置に入れる</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>%1 を%2スライドして %3 に差し込む</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>ここはあと %1 まで耐え、それを超えると %2 の %3 にひびが入ります。</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>ここは %1 まで耐え、それを超えると %2 の %3 にひびが入ります。</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>ここはあと %1 まで載せられ、それを超えると倒れます。</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>ここは %1 まで載せられ、それを超えると倒れます。</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>ここはあと %1 まで耐え、それを超えると接合部が抜けます。</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>ここは %1 まで耐え、それを超えると接合部が抜けます。</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>ここは %1 を超えても耐えます。</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>ここがどれだけ耐えるかは計算できませんでした。</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>台を広げる</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>足を追加</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>つながっている。まだ板は 1 枚だけです。</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>接合部 1 か所</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>接合部 %n か所</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>つながっている。2 枚の板とも、%1。</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>つながっている。板 %1 枚すべて、%2。</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>%1、つながるはず。</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 がほかとつながっていません。</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 がほかとつながっていません。</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 は %2 と交わっていますが、固定するものがありません。</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 は %2 と交わっていますが、固定するものがありません。</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>%1 はどこにも触れていません。%3 から %2 離れています。</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>%1 はほかのどこにも触れていません。%3 から %2 離れています。</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>削除する</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>すべて削除する</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>つながっている</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>つながるはず</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>つながっていない</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>両方と交わる板を描くか、一方を他方のところへ動かしてください。</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>まだつながっていない</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>ばらばらにならなければ</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>どこもばらばらにならなければ</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>切断幅でふさがるスリットがなければ</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>きつすぎるスリットがなければ</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>ゆるすぎるスリットがなければ</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>たたまれなければ</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>すべらなければ</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>外れなければ</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>接合部が抜けなければ</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>押す力がなければ</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>一方を他方のところで終わらせる</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 を %2 のところで終わらせる</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>この接合部は「なし」に設定されています。</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>差し込めるスリットがありません: クリアランスがマイナスで、幅がなくなります。クリアランスを大きくしてください。</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>差し込めるスリットがありません: 一方のところでは片方の向きにしか、もう一方のところでは逆の向きにしか動けません。どちらかの板を短くしてください。</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>固定するものがありません: スリットが始まるところに穴があります。穴を小さくするか、一方を他方の中で終わらせてください。</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>差し込めるスリットがありません: どちらの板も縁に届いていません。穴を外まで広げるか、一方を突き抜けさせてください。</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 と %2 が長さ %3 にわたって重なっている。%4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>%1 未満</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 と %2 がスリットの外で %3 重なっています。</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 と %2 が %3 重なっていますが、接合されていません。</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 と %2 はほぼ同じ平面にあります: 交わる角度が %3 で、%4 未満ではどんなスリットでも固定できません。</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 と %2 は %3 で交わっています（%4 未満ではスリットが広くなります）。</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>どちらかをよけるか、もう一方の手前で終わらせてください。</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>板が重なっている</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>角度が浅すぎる</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>一方を回して、もっと直角に近い角度で交わらせてください。</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>接合する</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 と接合する</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>すべて %1 と接合する</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 まで動かす</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>すべて %1 まで動かす</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を切り詰める</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>ほぞで接合する</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 は %2 を固定していません: スリットが縁に沿っていて、片側にしか材料がありません。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 は %2 を固定していません: そこで板がスリットで切り離されます。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 は %2 を固定していません: スリットの深さが %3 未満です。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 は %2 を固定していません: スリットの両側に材料が残りません。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 は %2 を固定していません: スリットに入るはずの部分が、ほかのスリットでなくなります。</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>スリットを縁から内側へ動かしてください。</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>そこで交わる板の 1 枚をほかの板の手前で終わらせるか、よけてください。</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>スリットが効いていない</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>%1 がスリットで %2 個の部品に分かれる</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 が %2 個の部品に分かれる</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1: そのうち 1 個（%2）がどこにも固定されません。</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1: どれも固定されません（最大のものは %2）。</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1: そのうち %2 個がどこにも固定されません（最大のものは %3）。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>%1 がスリットで切り離される。切り離された部分は互いにつながっていますが、どこにも固定されません。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>%1 がスリットで切り離される。切り離された部分が、%2 とともにどこにも固定されません。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>%1 がスリットで切り離される。%2 の部品が、%3 とともにどこにも固定されません。</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>スリットを反転</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>部品が外れている</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を縁から内側へ動かす</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を離す</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>スリットを浅くする</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>スリット %1 が %2 の切断幅でふさがる。材料のスリットのクリアランスを増やすか、切断幅を小さくしてください。</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>スリット %1 が %2 の工具より細い。材料のスリットのクリアランスを増やすか、細い工具を選んでください。</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>突起の間で、スリットが入るものより %1 細くなります。どんな材料でもきつすぎます。突起を小さくしてください。</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>スリットが入るものより %1 細い。どんな材料でもきつすぎます。</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>スリットが入るものより %1 広いため、ゆるくなります。</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>クリアランスを設定</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>スリットがきつすぎる</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>スリットがゆるすぎる</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>スリットが工具より細い</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度試す</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>報告用のコピーを表示</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>計算できない</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>組み立てられる。まだ部品は 1 個だけです。</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>組み立てられる。ただし、部品の 1 つがどこにも固定されません。</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>組み立てられる。ただし、部品の %n 個がどこにも固定されません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>組み立てられる。全 %n 手順。</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>%1、組み立てられるはず。</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>まだ組み立てられない。1 組の板の重なりをなくせば組み立てられます。</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>まだ組み立てられない。%n 組の板の重なりをなくせば組み立てられます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>手順を表示</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>板どうしがぶつかり合う。%1 は %2 で交わり、差し込む方向が %3 通りに分かれています。</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>板どうしがぶつかり合う。%1 は、スリットから %2 抜けたところで %3 に当たります。</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>板どうしがぶつかり合う。%1 のどれも、まっすぐには引き抜けません。</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>組み立て可能にする</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>接合部 1 か所を反転しました。</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>接合部 %n か所を反転しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>組み立て順が不明: %1。</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>組み立て順が不明。探すのに時間がかかりすぎました。モデルが悪いとは限りません。</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>組み立てられる</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>組み立てられるはず</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>まだ組み立てられない</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>組み立てられない</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>どれかを短くするか、ほかと同じ方向に差し込めるように回してください。</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>組み立て順が不明</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>接合部が抜ける。%1 と %2 の接合部が %3 N で引き離されます。</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>力を受けていない。%1 と %2 の接合部は %3 N で引き離されますが、なくてもほかの接合部だけでもちます。</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>摩擦だけで固定。%1 と %2 の接合部は %3 N で引っ張られ、きついはめ合いでしかもちません。</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>接合部が抜ける</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>力を受けていない</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>スリットを反転する</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>接着してください。</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>摩擦だけで固定</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>押し倒される。押す力がなければ自立します。</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>押し倒される</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>台を広げるか重くする、または押す力を弱くするか低い位置にしてください。</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 が輪になって接合されています: 手順の順番どおりに組み立ててください。</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 が輪になって接合されています: どれを最後に入れても、2 枚に同時に差し込むことになります。</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>板が %n つの輪になって接合されています: 手順の順番どおりに組み立ててください。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>板が %n つの輪になって接合されています: どの輪でも、最後に入れる 1 枚は 2 枚に同時に差し込むことになります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>輪になって接合</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>足で支える</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>シート 1 枚</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>シート %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>シートに収まる。%1、%2% を使用。</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>シートに収まる。%1（%2）、%3% を使用。</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%2 の部品 %1 個は、どう回しても、余白 %4 をとった %3 のシートに収まりません。</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1（%2）は、どう回しても、余白 %4 をとった %3 のシートに収まりません。</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>シートを選ぶ</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>シートに収まる</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>シートより大きい</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>すべて地面まで伸ばす</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を地面まで伸ばす</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>地面に下ろす</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>地面まで上げる</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>自立するが %1 がたつく。%2 まで傾けても倒れません。余裕 %3。</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>自立する。%1 まで傾けても倒れません。余裕 %2。</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>自立するが %1 傾く。%2 まで傾けても倒れません。余裕 %3。</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>%1 のいちばん低い点が、地面より %2 上にあります。</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>%1 のいちばん低い点が、地面より最大 %2 上にあります。</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>前に %1 傾く</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>後ろに %1 傾く</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>左に %1 傾く</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>右に %1 傾く</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1 がたつく: 低い点のすべてが地面に着いてはいません。%2 まで傾けても倒れません。</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1と立つ: 低い点のすべてが地面に着いてはいません。%2 まで傾けても倒れません。</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>%1、自立するはず。%2 まで傾けても倒れない計算です。余裕 %3。</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>触れるだけで倒れる: %1 傾けると倒れます。余裕 %2。</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>かろうじて自立: %1 傾けると倒れます。余裕 %2。</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>がたつく</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>傾く</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>触れるだけで倒れる</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>倒れやすい</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>前に倒れる。重心が足より %1 前にあります。</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>後ろに倒れる。重心が足より %1 後ろにあります。</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>左に倒れる。重心が足の外側へ %1 出ています。</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>右に倒れる。重心が足の外側へ %1 出ています。</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>倒れる。足が一直線に並んでいて、支えるものがありません。</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>地面に載っていない。いちばん低い点が地面より %1 上にあります。</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>地面に載っていない。いちばん低い点が地面より %1 上にあります。</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>足をもう 1 本付けるか、重さを足の上へ移してください。</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>自立しているものと接合するか、地面へ動かしてください。</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>まだ自立しない</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>まだ地面に載っていない</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>自立する</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>自立するはず</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>すべての足の高さをそろえてください。</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>倒れる</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>地面に載っていない</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>今の %1 倍</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>かかる荷重</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>強度は十分</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>%1 に耐える</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>強度は十分なはず</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>%1 に耐えるはず</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>ひびが入るおそれ</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>強度はぎりぎり</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>%1 でひびのおそれ</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>%1 にぎりぎり耐える</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>折れる</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>弱すぎる</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>%1 で折れる</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>%1 には弱すぎる</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 は %2 で %3 から折れます。</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 は %2 に %3 からひびが入るおそれがあり、</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>くびれは %1 で折れます。</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>%1 のくびれは %2 で折れます。</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 は %2 に %3 からひびが入るおそれがあります。</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>%1 で接合部が抜けます。</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>%1 で自立しなくなります。</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>これよりはるかに重くても耐えます。</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>どれだけ耐えるかは計算できませんでした。</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>どこにも負荷がかかっていません。</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>いちばん弱いのは %1 の %2 で、負荷は強度の 1% 未満です。</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>いちばん弱いのは %1 の %2 で、負荷は強度の %3% です。</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>%1 たわみます。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%2、%1</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>%1 のくびれの負荷は強度の %2% です。</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>これでは安全率 %1 に足りません。</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>強度が不明。%1 の材料に強度が設定されていません。</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>強度が不明。板の間に働く力を計算できませんでした。</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>強度が不明。%1 の応力を計算できませんでした。</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>すべる。足の踏ん張りが押す力に負けます。押す力を弱くするか、重くしてください。</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>外れる。%1 を留めるものがありません。接合部を接着するか、接合部を増やしてください。</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>たたまれる。フィンガーはちょうつがいのように回り、%1 の回転を止めるものがほかにありません。接着するか、もう 1 枚の板と接合してください。</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>材料から外れている。%1 のおもりの下に材料がないため、いちばん近いところで受けています。</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>厚い材料を使うか、そこの幅を広げるか、荷重を減らしてください。</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>強度が不明</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>外れる</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>たたまれる</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>材料から外れている</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>厚さ %1 の材料を使う</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>厚い材料を使う</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>強度を入力</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>ばらばらになる。%1 のつながりが、カットできないほど細くなっています。</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>材料が足りない。%1 に幅が %2 しかないところがあります。</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>ばらばらになる</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>そこの幅を広げるか、触れているものを離してください。</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>材料が足りない</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>そこの幅を広げてください。</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: %2 用のスリットどうしがつながってしまいます。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: %2 用のスリットの間に、材料が残りません。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: %2 用のスリットと穴の間に、材料が残りません。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: %2 用のスリットと縁の間に、材料が残りません。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: %3 用のスリットの間に、材料が %2 しか残りません。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: %3 用のスリットと穴の間に、材料が %2 しか残りません。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: %3 用のスリットと縁の間に、材料が %2 しか残りません。</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>かなり細い</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>そこで板の幅を広げるか、スリットを動かしてください。</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>スリットどうしがつながる</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>質量 %1。重心は地面から %2 の高さにあります。</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 と %2 は触れているだけです: 重なりが %3 未満です。</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n 組の板が触れているだけです: 重なりが %1 未満です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>触れているだけ</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を 90° にする</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のスリットから 1 mm² 未満のかけらが出ます。切りくずなので番号は付きません。</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>%1 のスリットから 1 mm² 未満のかけらが %n 個出ます。切りくずなので番号は付きません。</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>切りくず</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>%1 はスリットで %2 に分かれますが、ほかの板がつなぎ留めます。</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>部品 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>%1 はスリットで切ると何も残りません。</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1 を切り出せませんでした: スリットを除いた形を計算できません。書き出しはできません。質量はスリットなしの値です。</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 を計算できませんでした: 板が足りません。書き出しはできません。</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>スリットで分断</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>何も残らない</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>切り出せない</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>オペレーション失敗</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>そこの幅を広げる</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>板 %n 枚を移動</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>板 %n 枚を下へ %1 移動</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>板 %n 枚を上へ %1 移動</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>接合部 1 か所を反転</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>接合部 %n か所を反転</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 の厚さが %2 になる</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>接合部 1 か所でスリットの合わせ位置が移動</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>接合部 %n か所でスリットの合わせ位置が移動</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 を %2 移動</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 を %2 回転</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>板 %n 枚を回転</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>%1 のスリットの新しい接合部</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>新しい接合部 1 か所</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>新しい接合部 %n か所</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の形が変わる</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>板 %n 枚の形が変わる</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を追加</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>板 %n 枚を追加</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を削除</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>板 %n 枚を削除</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>ほかに切り離されるところはない</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>問題 1 件が解決</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>問題 %n 件が解決</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>その結果: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>新しい問題: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>新しい指摘 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>%1 用スリットの脇</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>%1 とのつなぎ目</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>内側の角</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>くびれ</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>複数の輪になって接合</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>地面に埋まっている。%1 が地面より %2 下に出ています。</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>地面に埋まっている。%1 が地面より最大 %2 下に出ています。</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>地面に埋まっている</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>平面を %1 % ずらす</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>各方向に平面を 1 つ増やす</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>手元のシートと端材に収まります。</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>シート 最大 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>シートに収まる。%1。</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>シートに収まる。%1（%2）。</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>板が少し重なっている</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>シートが足りないおそれ。%1 のシートが最大 %n 枚必要で、手元には %2 枚です。</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>シートが足りないおそれ</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>部品をどこまで詰められるかは「シート」で確かめてください。</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>平面を %1 ごとに置く</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1、%2 % ずらす</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>平面を 1 つ増やす</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>各方向に平面を 1 つ減らす</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>平面を 1 つ減らす</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>各方向に平面を 2 つ増やす</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>平面を 2 つ増やす</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>各方向に平面を 2 つ減らす</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>平面を 2 つ減らす</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>試したずらし方と平面の数では、どれも差し込めません。スライスを板に変換し、どれかを短くするか、取り除いてください。</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>このモデルは調整用です。「設計を編集」ですべて元に戻ります</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>モデルを開きます。FlatFab のモデルも開けます</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>モデルを挿入…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>挿入</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>別のモデルの板をこのモデルに追加します</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>なぞるための下絵…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>メッシュ、画像、図面を読み込んで、その上に板を描けるようにします</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>ライブラリに追加</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>ライブラリへ</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>選択部分を、ほかのモデルでも使えるようにライブラリに残します</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>モデルを保存します</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>別名で保存</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>モデルを別の名前で保存します</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>カットデータの書き出し…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>部品をレーザーカッター用のファイルに書き出します</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>もう一度書き出す</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>もう一度書き出す</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>同じ設定で同じファイルをもう一度書き出します</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>保存した状態に戻す</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>保存時に戻す</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>モデルをファイルに保存された状態に戻します。「元に戻す」で変更を取り戻せます</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>設定…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>単位、色、言語、ファイル、ショートカット</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>キーボードショートカット…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>キー操作</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>どのキーが何をするかを確認し、好みのキーに変えられます</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>ウィンドウを閉じる</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>このウィンドウを閉じます。ほかは開いたままです</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>すべてのウィンドウを閉じて終了します</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>プロパティへ移動</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>プロパティ</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>選択したものの最初の入力欄に移ります。ビューでは Enter でも移れます</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>すべてのパネルを隠す</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>パネルを隠す</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>左右のパネルを隠すか、表示します</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全画面</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全画面</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>ウィンドウを画面いっぱいに広げます</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>ウィンドウをリセット</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>ウィンドウをリセット</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>すべてのパネルを元の位置に戻します</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>ウィンドウの次の部分</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>次の部分</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>ウィンドウの次の部分へ移ります: ツールバー、左、ビュー、右</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>ウィンドウの前の部分</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>前の部分</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>ウィンドウの 1 つ前の部分へ戻ります</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>次の問題</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>次の問題</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>次の問題の板を選択して表示します</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>前の問題</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>前の問題</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>1 つ前の問題の板を選択します</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>手順を表示</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>モデルの組み立て方を手順ごとに表示します</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>シート材料: 厚さ、強度、切断幅、シートサイズ</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>テストピース…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>テストピース</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>どのスリットが合うか、加工機の切断幅がどれだけかを調べる試験片を書き出します</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>カットするとおりにシート上の部品を表示します</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>変数へ移動</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>モデルの数値のもとになる変数を調整します</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新しい変数</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>数値の欄で使える、名前の付いた数</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>コマンドを検索…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>入力して、プログラムにできることを何でも探せます</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>はじめの一歩</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>はじめの一歩</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>モデルの作り方を、図入りで順を追って説明します</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>最近使ったモデルとサンプル</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>FlatFitFab について</translation>
    </message>
    <message>
        <source>About</source>
        <translation>情報</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>このプログラムの説明、バージョン、ライセンス</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>まだ書き出していません</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>一度も保存されていません</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>保存後の変更はありません</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>強度マップ</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>強度マップ</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>各場所が耐えられる質量で板を色分けします</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>先に、調べる板を選択してください</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>先に板を 1 枚選択してください</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>接合部が選択されていません: 板を選択し、その接合部を選択してください</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>ほかに板がありません</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>オペレーションが選択されていません</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>まだ板がありません</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>板が選択されていません</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>選択した板をコピーして削除します</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>選択した板を、ほかのウィンドウやプログラムでも使えるようにコピーします</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>コピーした板、またはなぞるための画像を追加します</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>選択した板のコピーを隣に置きます</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>X=0 の面で</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>ミラー X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>X が 0 の平面の反対側に、選択した板の鏡像を置きます</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Y=0 の面で</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>ミラー Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Y が 0 の平面の反対側に、選択した板の鏡像を置きます</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Z=0 の面で</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>ミラー Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Z が 0 の平面の反対側に、選択した板の鏡像を置きます</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>板の面で…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>板をクリックすると、その反対側に選択した板の鏡像ができます</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>SVG から板…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>SVG から</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>図面の輪郭線ごとに板を作ります</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>SVG から輪郭…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>SVG から輪郭</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>選択した板の輪郭を、図面のいちばん大きな輪郭線に置き換えます</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>SVG から穴…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>SVG から穴</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>図面の輪郭線ごとに、選択した板に穴をあけます</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>SVG からマーク…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>SVG からマーク</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>図面の線を、選択した板に彫刻または筋入れします</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>図形を描く</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>図形</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>円や長方形などを中心からドラッグして描きます</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>数値で指定: 選択した板の穴、または独立した板</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>多角形</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多角形</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>長穴</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>長穴</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>下絵を動かす</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>ハンドル</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>下絵をハンドルまたは数値で移動・回転・拡大縮小します</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>線で下絵の大きさを決める</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>線で大きさ指定</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>下絵の上に線を引き、その長さを入力します</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>画像も図面もありません: 先に追加してください</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>下絵がありません: 先にメッシュか画像を追加してください</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>接合部のスリットを反転</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>スリットを反転</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>選択した接合部のスリットを反対側に開きます</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>自動設定に戻す</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>自動に戻す</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>選択した接合部の種類、向き、合わせ位置を、またプログラムに任せます</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>この接合部に手動の設定はありません</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>おもりを追加</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>おもり</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>板におもりを載せて、どれだけ耐えるかを調べます</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>押す力を追加</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>押す力</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>板の 1 点を押すか引いて、どれだけ耐えるかを調べます</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>ここを引く</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>引く</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>板をマウスで引っ張って、どうなるかを見ます。何も残りません</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>モデルに力がかかっていません: 先におもりか押す力を追加してください</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>引き寄せられるメッシュがありません</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>彫刻する文字や線を追加</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>彫刻</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>板に文字や線をかき、彫刻または筋入れにします</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>彫刻</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>次に描くものを彫刻にします</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>筋入れ</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>筋入れ</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>次に描くものを、折る・割るための筋入れにします</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>2 点間を測ります。長さを残すことも、モデルをそれに合わせて拡大縮小することもできます</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>長さに合わせて拡大縮小</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>長さに合わせて拡大縮小</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>長さを決めて、モデルをそれに合わせて拡大縮小します</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>長さを残す</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>この長さを表示したままにします</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>この寸法を外す</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>この寸法を外す</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>何も測っていません</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>寸法が選ばれていません: 「測定」でクリックしてください</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>ミラー…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>選択した板をミラーするか、モデルの片側を反対側にミラーします</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>左右にミラー（X）</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>X が 0 の平面でミラーします</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>上下にミラー（Y）</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Y が 0 の平面でミラーします</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>前後にミラー（Z）</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Z が 0 の平面でミラーします</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>板の面でミラー</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>クリックした板の平面でミラーします</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>選択部分のコピーをミラー</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>選択した板の鏡像を追加します</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>両側を同じに保つ</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>両側</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>片側に描いたものを、この先描くものも含めてすべてミラーします</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>一度だけ対称にする</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>一度だけ</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>片側を反対側にコピーします。後の編集はコピーされません</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>表示どおりにミラー</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>表示されているとおりに実行します</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>先に「ミラー」を選んでください</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>候補の形を使う</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>候補の形</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>今描いたものを、候補の円、楕円、直線、直角に変えるか、スリットを縁から内側へ動かします</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>ガイド全体を使う</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>ガイドを使う</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>平面が下絵を切り取る形のすべてから、穴も含めて板を作ります</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>今描いたものに候補の形はありません</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>描いている平面は、どの下絵も切っていません</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>板を別の板に沿って一列に繰り返します</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>輪郭に沿って周回</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>周回</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>板を別の板の輪郭の周りに繰り返します</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>ブレンド</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>ブレンド</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>板と板の間を補間します</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>枝分かれ</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>枝分かれ</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>木のように、板のコピーを板から次々に伸ばします</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>コネクタ付き格子</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>シートより大きい板を分割します</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>放射形の輪郭</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>放射形</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>板を円、星、歯車にするか、そうした穴をあけます</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>モデルをミラー</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>片側に描いたものを、すべて反対側にも繰り返します</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>回転対称</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>回転対称</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>一度描いたものを、すべて軸の周りに繰り返します</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>配列</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>配列</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>板を空間の直線に沿って繰り返します</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>メッシュのスライス</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>スライス</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>下絵のメッシュを、その形に沿った板に切り分けます</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>今すぐ対称にする</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>対称にする</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>片側を反対側に一度だけミラーします</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>オン・オフ切り替え</translation>
    </message>
    <message>
        <source>On</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>選択したオペレーションのオン・オフを切り替えます</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>順番を前へ</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>前へ</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>選択したオペレーションを、1 つ上のものより先に実行します</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>順番を後へ</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後へ</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>選択したオペレーションを、1 つ下のものより後に実行します</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>板に変換</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>板に変換</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>選択したオペレーションが作るものを、描いた板に変えます</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>スライスするメッシュがありません: 先に追加してください</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>すでに最初です</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>すでに最後です</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>スナップ</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>スナップ</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>点、補助線、グリッドにスナップします</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>一筆ではなくクリックで描きます: 点を打ち、ドラッグで曲げます</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>数値が入力されていません</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>穴をなくす</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>穴なし</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>選択した板の穴をすべてふさぎます</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>点を追加</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>点を追加</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>カーソルの位置、または選択した点の隣に制御点を追加します</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>点を削除</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>点を削除</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>選択した制御点を削除します</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>スムーズ点</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>スムーズ</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>選択した点で輪郭をなめらかにします</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>対称点</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>両側のハンドルの長さをそろえて、輪郭をなめらかにします</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>コーナー点</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>コーナー</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>選択した点をコーナーにします</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>輪郭の点が選択されていません</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>輪郭を編集できる板を 1 枚選択してください</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>選択した板に穴はありません</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>移動と回転</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>ハンドルまたは数値で移動・回転・拡大縮小します</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>ワールド軸に沿って</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>ワールド軸</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>板の平面内ではなく、ワールド軸に沿って動かします</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>付いている板も一緒に動かす</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>一緒に移動</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>この板の上に描いた板も一緒に動きます</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>別の板に取り付ける…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>取り付け</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>選択した板を取り付ける相手の板をクリックします</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>親の板から独立</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>独立</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>親の板との関係を切ります: 一緒に動かず、角度も保たなくなります</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>直角にする</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>直角</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>板を、取り付け先の板に対して直角にします</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>近い軸にそろえる</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>そろえる</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>板を、ワールド軸の方向を向くように回します</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>選択した板が変更されないように保護します</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>元の板を編集</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>元を編集</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>選択した板の元になっている板を選択します</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>これを切り離す</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>切り離し</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>選択した板を描いた板に変えます。ほかの板は引き続きオペレーションが作ります</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>これを除外</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>選択した板を除外します。ほかの板は引き続きオペレーションが作ります</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>選択したものは、ほかの板に取り付けられていません</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>選択したものは、オペレーションが作ったものです</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>選択したものは対称ではありません</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>選択したものは、オペレーションが作ったものではなく、描いたものです</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>すべての板を選択します</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>次を選択</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>次の板を選択します</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>前を選択</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>1 つ前の板を選択します</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>つながる板を選択</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>つながる板</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>選択した板につながる板をすべて選択します</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>平行な板を選択</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>選択した板に平行な板をすべて選択します</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>同じ材料を選択</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>同じ材料</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>選択した板と同じ材料の板をすべて選択します</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>新しいモデルを始めます</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>最後の操作を元に戻します</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>元に戻した操作をやり直します</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>選択した板を削除します</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>点を打つ</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>元に戻すものがありません</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>「%1」を元に戻す</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>やり直すものがありません</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>「%1」をやり直す</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>すべての部品のピン留めを解除</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>ピン留め解除</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>板取りのとき、すべての部品を動かせるようにします</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>シートにピン留めされた部品はありません</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>スキン</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>スキン</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>板が表す形を、板を覆う面として表示します</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>板ごとの対称</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>スリットの片側だけに描いた輪郭を、反対側にミラーします</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>地面で平らに切る</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>地面より下に描いた部分を切り落とします</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>地面に</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>地面に</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>地面に寝かせた板を描きます</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>正面の平面に</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>正面に</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>中央に立つ板を、正面から見て描きます</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>側面の平面に</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>側面に</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>中央に立つ板を、側面から見て描きます</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>板に平行に</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>選択した板に平行な板を描きます</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>輪郭を描き直す</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>描き直し</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>選択した板の輪郭を新しく描きます</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>穴を描く</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>選択した板に穴を描きます</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>地面に下ろす</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>下ろす</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>モデルを地面に下ろします</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>モデルはすでに地面に載っています</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>調整用に配布</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>配布</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>保存したモデルを開いた人には、ビュー、公開された変数、書き出しだけが見えます</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>設計を編集</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>ほかの人が調整できる変数がまだありません</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>正面から見ます</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上面</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上面</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>上から見ます</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右側面</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右側面</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>右から見ます</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>後ろから見ます</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>下面</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下面</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>下から見ます</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左側面</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左側面</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>左から見ます</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>次の角</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>次の角から見ます</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>板を正面に見る</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>正対</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>選択した板を真正面から見ます</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>モデル全体を表示します</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>選択部分を表示</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>選択部分を表示</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>選択した板をできるだけ大きく表示します</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>前のビュー</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>1 つ前のビューに戻ります</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>遠近法</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>遠近法</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>目で見るように、遠いものを小さく表示します</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>透過表示</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>透過表示</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>すべての板を透かして、スリットまで見せます</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>選択部分だけ</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>選択だけ</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>ほかの板をすべて淡く表示します</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>選択した板を隠します</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>隠した板をもう一度表示します</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>断面を表示</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>モデルを平面で切り開いて、中を見ます</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>地面と影</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>グリッド付きの地面とモデルの影を表示します</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>応力線</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>応力</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>モデルのどこにいちばん負荷がかかるかを表示します</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>隠れている板はありません</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>これより前のビューはありません</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>シンプルなウィンドウにはありません。「設定」ですべて表示できます</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>3 分で最初のモデル</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>空のウィンドウで、モデルを描き、チェックし、カットするまでを一歩ずつ</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>カーソルの下にあるもののヘルプ</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>ウィンドウのこの部分を説明するところを開きます</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>ミラーしない</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>すべて元のままにします</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>ほかのプログラム用に JSON を出力します。</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>モデルの板、接合部、大きさ、質量</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>ばらばらにならないか、自立するか、組み立てられるか、シートに収まるか</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>強度は十分か: 力、応力、耐えられる荷重</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>切り出す部品（各板の座標系で）</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>モデルの画像（ディスプレイが必要）</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>組み立て方を手順ごとに（ディスプレイが必要）</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>モデルの名前付き変数と、それから作られるもの</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>変数の表の各行について、カットデータと判定</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>すべての種類のオペレーション、またはモデルのオペレーション</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>平面がメッシュを切るループ</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>メッシュを表し、自立し、組み立てられる板</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>メッシュをスライスしたモデル</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>辺にフィンガーの付いた平らな板のモデル</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>シートに詰めて並べた部品、または帯に並べる図形（.json）</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>ウィンドウでの人の操作を記録したスクリプトを再生します</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>スリットですべて切り取られ、部品が残りません: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>シートに収まらず、専用のシートに置きました: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>細すぎて番号を入れられません: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>切断幅より細い穴や切り込みはカットされません: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>すべての接合部の番号を入れる場所がありません: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>標準出力に書き込めませんでした。</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>チェックするものがありません: モデルに板がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>接合部が荷重を分け合うところで板のたわみを有限要素法で計算します（数秒かかります）。</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>荷重が何か月もかかり続けるものとします: 各材料の強度は、その割合だけになります。</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>「%1」はありません。</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>用途別レイヤー付きの DXF</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>DXF ファイルのバージョン: r2000 または r12（r2000）。</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>モデルそのもの</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>FlatFab ファイルの 1 単位あたりのミリメートル（25.4）。</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>レーザー用の G-code</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>LightBurn プロジェクト</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>組んだ状態のソリッド</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>部品リスト</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>実寸の PDF</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>PDF ファイルのページ: sheet、または a4 か letter に分割（sheet）。</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>シートの画像</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>STL・3MF ファイルでの部品の置き方: in-place、またはシート上に平らに置く flat（in-place）。</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>3D プリント用の部品</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>実寸のカットデータ</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>工房用一式</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>OpenGL 3.3 を使えるディスプレイがありません。</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>このコンピューターが混み合っているため、探索を途中で止めました。次に実行すると別の配置になることがあります。</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>試すスリット</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>差し込む帯</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>測る細板</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>縁に近すぎます: このスリットでは固定できません</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>縁に近すぎます: このスリットでは固定できません。B: 内側へ動かす</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>%1 内側へ動かしました。B: 元に戻す</translation>
    </message>
    <message>
        <source>level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>縁に直角</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>前のものと平行</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>回転中…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>輪郭を描いてください</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>まだ届いていません</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>「%1」は %2 になりますが、ここでは使えません。</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>「%1」ともう 1 つの式が、ここを同時に別の値にしようとしています。</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>この数値の相手がなくなっています。</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>寸法</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>中心の X</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>中心の Y</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>文字の高さ</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>クリアランス</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切断幅</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>シートの幅</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>シートの高さ</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>工具の直径</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>スリットの入口面取り</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>スリットの突起</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>中身</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>X 方向の力</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Y 方向の力</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>面に垂直な力</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>合わせ位置</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>「%1」はここでは使えません。変数に従う数値により %2 のままです。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>「%1」はここでは使えません。%2 が「%3」に従っているため変わりません。</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>「%1」は計算できません。</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>「%1」は空です。ここでは空にできません。</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>メッシュ（これは平らです）</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>中身の一覧が壊れています</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>この項目は壊れています</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>この項目は暗号化されています</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>このファイルには中身のほかに余分なデータがあります</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>この項目が 2 つあります</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>この項目は未知の方式で圧縮されています</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>この項目の名前が中身の一覧と違います</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>中の項目がバイトを共有しています</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>この項目は展開すると大きくなりすぎます</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>壊れていない gzip データ</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>gzip データの残り</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>もっと大きいシート</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>ファイルには名前が必要です</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>このファイルは読み取り専用です</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>このフォルダーは読み取り専用です</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>これはフォルダーです</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>この値はここでは使えません</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>何もありません（必要: %1）</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>「%1」が見つかりました（必要: %2）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>この個数は不可能です</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>個数が %1 です（上限: %2）</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>%3の数が %1 です（上限: %2）</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>新しいバージョンの FlatFitFab で作られています</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>新しいバージョンの FlatFitFab で作られています: 形式 %1（読めるのは %2 まで）</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>これらの制御点では閉じた輪郭になりません</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>これらの制御点では閉じた輪郭になりません: %1 個あります（必要: %2）</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>この輪郭線の全周を、切断幅の半分の距離でたどれるパスがありません</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>%1 の全周を、切断幅 %2 mm の半分の距離でたどれるパスがありません。輪郭の細かい部分をなめらかにするか、材料の切断幅を変えてください</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>切断幅でスリットがふさがります</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 に幅 %2 mm のスリットがあり、切断幅 %3 mm ではふさがります</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 ファイル</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>%2 の %1 ファイル</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 または %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>開けませんでした</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>書き込めませんでした</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>モデルではありません（必要: %1）</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>ファイルがここで終わっています（必要: %1）</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>ファイルが途中で終わっています</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>「%1」が見つかりました（必要: 有限の数値）</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>数値が有限ではありません</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>これらの軸では座標系になりません（必要: 直角に交わる長さ 1 の 2 本）</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>この輪郭は面積を囲んでいません</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>番号 %1 のものはありません</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>存在しないものを参照しています</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>番号 %1 が 2 回使われています（必要: 固有の番号）</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>この番号が 2 回使われています（必要: 固有の番号）</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>この 2 枚の板はほぼ平行で、接合できません</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>この輪郭は自分自身と交差しています</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>穴が縁または別の穴に触れてしまいます</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>残る点が少なすぎて、何も囲めません</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>どの板もスリットで切ると何も残らず、カットするものがありません</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>まだ板がないので、カットするものがありません</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>輪郭の間をどこも覆えないため（%1）、スキンはできません</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>縁で交わる輪郭がないため、スキンはできません</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>「%1」というコマンドはありません</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>そのようなコマンドはありません</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>このイベントはここでは意味がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>「%1」はこのバージョンでは使えません</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>これはこのバージョンでは使えません</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>計算できませんでした</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>「%1」を切り出せませんでした: スリットを除いた形を計算できません</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>板を切り出せませんでした</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>「%1」のソリッドを計算できませんでした</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>ソリッドを計算できませんでした</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>「%1」のマークを縁で切り取れませんでした</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>板のマークを縁で切り取れませんでした</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>オペレーション「%1」の板を計算できませんでした</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>オペレーションの板を計算できませんでした</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>FlatFitFab の内部で問題が起きました（%1）</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>FlatFitFab の内部で問題が起きました</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>中止されました</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>このファイルの中身は壊れています</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 が少しゆがんでいたため、まっすぐにしました</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>板が少しゆがんでいたため、まっすぐにしました</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>%1 の輪郭が自分自身と交差しているため、最大のループを残しました</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>輪郭が自分自身と交差しているため、最大のループを残しました</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>%1 の穴が輪郭からはみ出しているため、除きました</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>穴が輪郭からはみ出しているため、除きました</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>%1 の穴に面積がないため、除きました</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>穴に面積がないため、除きました</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>%1 の穴が重なっているため、1 つにまとめました</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>穴が重なっているため、1 つにまとめました</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>%1 の穴が輪郭からはみ出しているため、輪郭から切り取りました</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>穴が輪郭からはみ出しているため、輪郭から切り取りました</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>最後の板より後の行は無視しました</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>最後の板より後の文字は無視しました（行数: %1）</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 は読み込めなかったため、除きました</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>画像またはメッシュを 1 つ除きました</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 を除きました: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>%1 の内容を読み込めませんでした（場所だけ残しました）</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>下絵を読み込めませんでした（場所だけ残しました）</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved または scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>区間ごとに 3 個と、もう 1 個の制御点</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>1 本以上の線</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>2 つの異なる位置</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>文字と数字からなる単語（一度だけ）</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>データがありません</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>16 進数 64 桁の SHA-256</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>この名前の項目はここにあるべきではありません</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>この項目のデータが、その名前（SHA-256）と一致しません</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>この項目がありません</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>文書のどこからもこの項目が参照されていません</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point、patch、edge のいずれか</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point、patch、edge、hanging のいずれか</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>1 から 10000 mm の幅</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>0 より大きく 1000000 N 以下の力 [x, y, z]</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>0 から 10000 mm の高さ</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>その質量の一部</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden または detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>作成以外の指定（各インスタンス一度だけ）</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>nextId より小さい id</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>0 より大きく 1 以下の割合</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>マイナスの厚さより大きい値</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>0 より大きい幅と高さ</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square、round、dogbone、tBone のいずれか</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>区間ごとに 3 個、合計 6 個以上の制御点</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion、left、right、bottom、top のいずれか</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>長さ 1 の方向</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap、mortise、tabs、none のいずれか</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>0.05 から 0.95 の割合</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>2 枚の板への指定（組は昇順）</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>自分の子の子孫ではない親</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>1 つ以上の材料</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>板の順に、各部品を一度ずつ</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>順番どおりに、各板を一度ずつ</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none、half、quarter、free のいずれか</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh、picture、curves のいずれか</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>なし: 引き寄せられるのはメッシュだけです</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>0.1 から 1000 mm の半径</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>ファイルのパス</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>ブロブの SHA-256、またはファイル</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>なし: メッシュは板の上に置けません</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>1e-9 から 1e9 の倍率</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>0 から 1 の不透明度</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals または groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>もっと短い式</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number、length、angle、count、mass、ratio、text、choice、switch のいずれか</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>「=」を含まない名前（それぞれ一度だけ）</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>各変数は一度だけ</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>文字と数字からなる単語（それぞれ一度だけ）</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>各数値は一度だけ</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>1000000 mm 以下の長さ</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>最初の点を繰り返す最後の制御点</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>個数</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>2 つの数値からなる点</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>区間ごとに 3 個と、最初の点をもう一度、合計 7 個以上の制御点</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>1 本以上の曲線</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>バイトのあるバッファー</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>ファイルの中のバッファー</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>バッファーに収まる長さ</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>glTF にある数値の型</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>バッファーにあるだけの値</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>そこに入るだけの数値</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>自分自身の中にないノード</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>GLB ファイルのチャンク</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>GLB バージョン 2</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>glTF ファイル</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>glTF バージョン 2</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>0 より大きく 1000000 以下の数値</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>0 から 1000000 の数値</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>範囲内の整数</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>点 [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>点 [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>点のリスト</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>引用符で囲んだ名前、またはオブジェクトの終わり</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>コロン</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>コンマ、またはリストの終わり</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>JSON のエスケープシーケンス</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>UTF-8 の文字列</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>引用符で囲んだ文字列の終わり</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>コンマの後の次の値</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>1024 階層以下</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>もっと小さいファイル</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>ファイルの終わり</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>オブジェクトの各キーは一度だけ</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>1 文字の前半と後半の両方</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>#ff0000 などの色</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>線の幅（mm）</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>速度（mm/s）</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>G-code 1 行</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>G-code の行</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>S の最大値</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>幅と高さ（mm）</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>0 から 1 の割合</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>ブリッジの幅（mm）</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>リードインの長さ（mm）</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>加工機の一覧</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>加工機</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>別のフォルダーにあります</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>3 つ以上の点</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon または polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>1 つ以上の角度</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>帯への板取りの問題</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>1 つ以上の図形</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>面の頂点が 3 つ以上</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>頂点の数</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>面の数</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>面の頂点</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>ピクセル</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>画像が壊れています</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>画像の残り</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>画像がここで壊れています</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>PNG、JPEG、WebP のいずれかの画像</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>1 ピクセル以上の画像</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>このパイプに書き込むものがありません</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>10 秒間、何も出力されませんでした</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>このパイプを読むものがありません</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element または end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii または binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>float や int などの型</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>先に element</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>ファイルに書かれた数だけの値</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x、y、z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>リストの長さ</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>ディスクがいっぱいです</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>三角形の数</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>ファイルに書かれた数だけの三角形</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet または endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex または endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>三角形の 3 つの頂点</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>線（文字は先にパスに変換してください）</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>線（画像は先にトレースしてください）</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>線、図形、またはパス</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>変換</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>グループの中のグループ</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>1 キロメートル以内の位置</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>数値の組</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>パスデータ</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>要素と属性</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>SVG 図面</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>画像または図面</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>このファイルには 3D モデルがありません</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>3D モデル</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>millimeter などの単位</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>12 個の数値</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>自分自身を含まないオブジェクト</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>板 %n 枚が少しゆがんでいたため、まっすぐにしました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>輪郭 %n 本が自分自身と交差していたため、それぞれ最大のループを残しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>穴 %n 個が輪郭からはみ出していたため、除きました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>穴 %n 個に面積がないため、除きました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>板 %n 枚の穴が重なっていたため、まとめました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>穴 %n 個が輪郭からはみ出していたため、輪郭から切り取りました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>最後の板より後の文字を %n か所で無視しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>画像やメッシュ %n 個は読み込めなかったため、除きました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>下絵 %n 個を読み込めませんでした。場所だけ残しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>このフォルダーは使えません</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>別のウィンドウで開いています</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>線が自分自身と交差する箇所</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>データが壊れています</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>三角形が 1 つ以上あるメッシュ</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>3 つ以上の面が集まる辺</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>2 つの面が辺で接するメッシュ</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>「%1」に従うはずの数値は、ただの数値になりました</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n 個の数値は、入力された式に従わなくなりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>各加工機を 1 回ずつ、順番どおりに</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>端材</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>0, 0 から始まる、自分と交差しない輪郭線</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>シートが取りうる値</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>輪郭線が開いています: 両端が %1 mm 離れています</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>1e12 までの座標</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>配置されたオブジェクト</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>角の半径</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多角形</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>辺の数</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>内側の直径</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>先端の数</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>長穴</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>作れない</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF、実寸</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF、シートごとに 1 つ</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>古いプログラム用の DXF、R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>FlatFitFab モデル</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>GRBL レーザー用の G-code</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code、シートごとに 1 つ</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>glTF メッシュ</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>LightBurn プロジェクト</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn、シートごとに 1 つ</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>OBJ メッシュ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ、組んだ状態のソリッド</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ、メッシュのスキン</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>OFF メッシュ</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>表計算用の部品リスト</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF、シートごとに 1 ページ</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF、A4 に分割</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF、Letter に分割</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>PLY メッシュ</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>シートの画像</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>画像、シートごとに 1 つ</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>STL メッシュ</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL、組んだ状態のソリッド</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL、メッシュのスキン</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL、平らに置いたソリッド</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG、実寸</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG、シートごとに 1 つ</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>3MF メッシュ</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF、組んだ状態のソリッド</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF、平らに置いたソリッド</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>工房用一式（圧縮）</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>工房用一式（フォルダー）</translation>
    </message>
</context>
<context>
    <name>FullStop</name>
    <message>
        <source>%1.</source>
        <extracomment>%1 is a sentence; what ends one in this language</extracomment>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>&lt;kbd&gt;%1&lt;/kbd&gt; undoes it.</source>
        <extracomment>%1 is what is pressed; follows &quot;The contour crosses itself; the largest loop was kept.&quot;</extracomment>
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; で元に戻します。</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>動かしていません: %1 と %2 が交わるところに、深さを分け合う 2 本のスリットがありません。</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>変更していません: %1 と %2 はそのようには接合できません。</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>反転していません: %1 と %2 のスリットは反対側に開けません。</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>切り詰めていません: %1 が %2 に入っていないか、何も残らなくなります。</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>動かすと断面がずれ、離すとそこに決まります。&lt;kbd&gt;Esc&lt;/kbd&gt; で元に戻します。</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>真横から見た平面には描けません: ビューを回して続けてください。</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>パスを破棄しました: 描いていた板がなくなりました。</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>描けませんでした: この線からは板を作れません。開いた 1 つのループとして描いてください。</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>描けませんでした: 全体が地面より下にあり、切り落とされます。</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>穴はあきませんでした: 穴は %1 の中にあり、板を分断しないことが必要です。</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>穴が %1 の縁からはみ出しているため、板から切り取りました。</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>穴が %1 のほかの穴に触れたため、1 つの穴にしました。</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>%1 の穴のうち、新しい輪郭の外にあるものを除きました。</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>地面に板を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>正面の平面に板を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>側面の平面に板を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>%1 に平行な板を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>%1 の新しい輪郭を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で元の輪郭のままにします。</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>%1 の穴を一筆で描いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>穴を描きます: 穴をあける板の上から始めてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>読み込めませんでした: %1 には閉じた輪郭線がありません。彫刻には使えます。</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%1 の輪郭線 %n 本は合わないため、除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 を飛ばし、%3。</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 と %3 を飛ばし、%4。</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>テキスト %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>画像 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>線 %n 本を読み込みました</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 が %1 に対して斜めになっています: 先に %1 の平面へ動かしてください。</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 の輪郭線が %n 本あり、多すぎます: もっと粗くトレースするか、先になめらかにしてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>トレースできませんでした: %1 にはしきい値のそちら側の部分がありません。</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: 中心から外へドラッグしてください。クリックすると標準の大きさになります。</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: 中心から外へドラッグして %2 から切り抜きます。</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとこの大きさになります。&lt;kbd&gt;Shift&lt;/kbd&gt; で縦横を同じにします。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>最初の板を描きましょう: ボタンを押し、形を一筆で描いて、離します。</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>ドラッグでビューを回します。&lt;kbd&gt;Shift&lt;/kbd&gt; を押しながらドラッグすると、まとめて選択します。</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>%1 から外へドラッグすると、交差する板を描きます。クリックで選択します。</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>クリックで %1 を選択します。真横から見た板には描けないので、ドラッグでビューを回してください。</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>ドラッグでモデルの断面を動かします。&lt;kbd&gt;Esc&lt;/kbd&gt; で閉じます。</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>クリックで問題 %1 を選択します。</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>ドラッグで点を動かします。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにし、矢印キーで 1 mm 動かします。</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>ドラッグで曲線を曲げます。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにし、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を保ちます。</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>ダブルクリックでここに点を追加し、ドラッグで輪郭を曲げます。</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>クリックで %1 と %2 の接合部を選択します。</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>ドラッグで %1 のスリットを深く、%2 のスリットを浅くします。クリックで接合部を選択します。</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>ドラッグで %1 のスリットを深く、%2 のスリットを浅くします。矢印キーで 1 mm 動かします。</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>ドラッグで %2 の上のおもり %1 を動かします。クリックで選択します。</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>矢印キーで %2 の上のおもり %1 を 1 mm 動かします。&lt;kbd&gt;+&lt;/kbd&gt; と &lt;kbd&gt;−&lt;/kbd&gt; で変え、&lt;kbd&gt;Delete&lt;/kbd&gt; で取り除きます。</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>ドラッグで %2 を押す力 %1 を動かし、矢印の先で向きを変えます。クリックで選択します。</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>矢印キーで %2 を押す力 %1 を 1 mm 動かします。&lt;kbd&gt;+&lt;/kbd&gt; と &lt;kbd&gt;−&lt;/kbd&gt; で変え、&lt;kbd&gt;Delete&lt;/kbd&gt; で取り除きます。</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 は %2 が作ったものです: クリックで全体を、もう一度クリックでこれだけを編集します。</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>クリックで %1 だけを選択します。外へドラッグすると、交差する板を描きます。</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>丸いハンドルをドラッグして %1 の始まりや終わりを動かします。板をクリックすると、その板を選択します。</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>ドラッグで %1 の始まりを動かします。クリックで数値を入力します。</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>ドラッグで %1 の終わりを動かします。クリックで数値を入力します。</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>クリックで正面から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>クリックで後ろから見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>クリックで左から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>クリックで右から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>クリックで上から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>クリックで下から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>クリックでこの辺から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>クリックでこの角から見ます。ドラッグでビューを回します。</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>ドラッグでビューを回し、ホイールで拡大縮小します。</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとここに決まります: %1 のスリットが %2% になります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>板の上をクリックして、そこに %1 を置いてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で終わります。</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>板の上でボタンを押し、押す方向へドラッグしてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で終わります。</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>板の上でボタンを押し、ドラッグで引っ張ってみてください。何も残りません。</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>離すと引くのをやめます。何も残りません。</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>ドラッグで動かします。&lt;b&gt;クリック&lt;/b&gt;で選択します。</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>矢印の先をドラッグして向きを変えます。矢印が長いほど強く押します。</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>離すとここにおもりを置きます。&lt;kbd&gt;Esc&lt;/kbd&gt; で元に戻します。</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>離すとここを押します。&lt;kbd&gt;Esc&lt;/kbd&gt; で元に戻します。</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>おもりを追加していません: 板の上をクリックしてください。</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>押す力を追加していません: 板の上でボタンを押してください。</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のコピーにもかかります。&lt;i&gt;プロパティ&lt;/i&gt;でこの板だけにできます。</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%1 のコピー %n 枚にもかかります。&lt;i&gt;プロパティ&lt;/i&gt;でこの板だけにできます。</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>おもりは元の位置のままです: そこは %1 から外れています。</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>押す力は元の位置のままです: そこは %1 から外れています。</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>ドラッグで、%1 が下絵を引き寄せる距離を決めます。</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>離すと、%1 が %2 以内の下絵を引き寄せます。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>彫刻する板の上に描くか、板をクリックしてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>ドラッグで %1 に線を描きます。&lt;kbd&gt;Shift&lt;/kbd&gt; でまっすぐにします。クリックで文字を置きます。</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すと線が決まります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 の彫刻は、レーザーが届くおもて面に入ります。ビューをその面に向けました。</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>彫刻していません: そこは %1 の上ではありません。</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>文字「%1」は彫刻できません。</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>ある位置から別の位置へドラッグして測ります。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でスナップしません。&lt;kbd&gt;Esc&lt;/kbd&gt; で終わります。</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>2 つ目の位置へ動かしてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>クリックまたはドラッグで測り直します。&lt;kbd&gt;Esc&lt;/kbd&gt; で消します。</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>長さのわかるところに沿ってドラッグしてください。モデル全体がそれに合います。&lt;kbd&gt;Esc&lt;/kbd&gt; で終わります。</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>目標の長さを入力してください。&lt;kbd&gt;Enter&lt;/kbd&gt; でモデル全体を拡大縮小します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>モデルをそこまで大きく、または小さくはできません。</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>そこまで拡大縮小できません: %1 が限界を超えます。</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>ミラーの面にする板をクリックしてください。ドラッグでビューを回します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: 円にする</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: 楕円にする</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: 線をまっすぐにする</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: 角を直角にする</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: スリットを縁から内側へ動かす</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>円にしました。</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>楕円にしました。</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>線をまっすぐにしました。</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>角を直角にしました。</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>縁から内側へ動かしました。</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 は描いたところに残します: 内側へ動かすと、スリットが %2 を切り刻んでしまいます。縁に沿ってではなく、縁をまたいで描いてください。</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>離すと %1 がここ（%2%）から始まります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>離すと %1 がここ（%2%）で終わります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>板から外へドラッグすると、交差する板をペンで描きます。ここをドラッグするとビューを回します。&lt;kbd&gt;Esc&lt;/kbd&gt; でペンをしまいます。</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>%1 から外へドラッグすると、交差する板をペンで描きます。クリックで選択します。</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>クリックで最初の点を打ち、ドラッグで曲げます。&lt;kbd&gt;Esc&lt;/kbd&gt; でペンをしまいます。</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>クリックで点を打ち、ドラッグで曲げます。&lt;kbd&gt;Enter&lt;/kbd&gt; で閉じ、&lt;kbd&gt;Backspace&lt;/kbd&gt; で 1 つ戻します。</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>クリックで点を打ち、ドラッグで曲げます。&lt;kbd&gt;Enter&lt;/kbd&gt; で閉じ、&lt;kbd&gt;Backspace&lt;/kbd&gt; で 1 つ戻します。&lt;kbd&gt;Ctrl&lt;/kbd&gt; を押しながらクリックするとスナップしません。</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>輪郭が自分自身と交差しています: &lt;kbd&gt;Enter&lt;/kbd&gt; で最大のループを残し、&lt;kbd&gt;Backspace&lt;/kbd&gt; で点を 1 つ戻します。</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>ドラッグで曲げます。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにし、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を保ちます。</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>ドラッグで点を動かします。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でスナップせず、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を保ちます。</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>ハンドルをドラッグして曲げます。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにします。</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>クリックで輪郭を閉じます。ドラッグで点を動かします。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; で点を打ち、&lt;kbd&gt;Tab&lt;/kbd&gt; で次の数値に移ります。&lt;kbd&gt;Esc&lt;/kbd&gt; でバーを閉じます。</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>閉じられません: まだ何も囲んでいません。</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>輪郭がまだ開いています: &lt;kbd&gt;Enter&lt;/kbd&gt; で閉じ、&lt;kbd&gt;Esc&lt;/kbd&gt; で取り消します。</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 現在: %2。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 現在: %2。&lt;kbd&gt;Enter&lt;/kbd&gt; で作成します。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; で作成します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>離すとここに決まります。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにし、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を保ちます。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>離すとこのまま決まります。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコーナーにし、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を保ちます。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとこのまま決まります。&lt;kbd&gt;Ctrl&lt;/kbd&gt; で両端をコーナーにします。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>ここでは輪郭が自分自身と交差するため、直前の形のままにします。</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>ここでは穴が縁や別の穴に触れるため、直前の形のままにします。</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>ここでは %1 がすべて地面で切り落とされるため、元のままにします。</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>削除していません: 輪郭には 2 つ以上の点が必要です。</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すと、完全に囲まれたものをすべて選択します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すと中の点を選択します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 は %2 との角度を保ちます。自由に回すには独立させてください。</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 はほかの板に取り付けられていないため、角度がありません。</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 は %2 に取り付けられません。%2 が %1 に取り付けられているためです。</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 と %2 が交わっていません: 先に一方を動かして交差させてください。</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>%1 を取り付ける板をクリックしてください。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>ドラッグでビューを回します。&lt;kbd&gt;Space&lt;/kbd&gt; で再生し、&lt;kbd&gt;←&lt;/kbd&gt; と &lt;kbd&gt;→&lt;/kbd&gt; で 1 手順ずつ進みます。&lt;kbd&gt;Esc&lt;/kbd&gt; で手順を閉じます。</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>モデルが変わったため、手順の表示を閉じました。</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>そのままドラッグして %1 の外へ出てください。スリットは縁で終わります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>そのままドラッグして %1 の外へ出てください。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でスリットを描いたままにします。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>ビューが回転中です: すぐに描き続けても、止まるまで待ってもかまいません。</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>輪郭を描いてください: 始めたいところで灰色の範囲から出ます。ここで離すと中止します。</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>輪郭を描き、離すと閉じます。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と板ができます。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と %1 に穴があきます。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と %1 がこの輪郭になります。&lt;kbd&gt;Esc&lt;/kbd&gt; で元の輪郭のままにします。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と、スリットでミラーした板ができます。&lt;kbd&gt;Shift&lt;/kbd&gt; を押すとこの側だけ残します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と、ミラーした板ができます。&lt;kbd&gt;Shift&lt;/kbd&gt; を離すとこの側だけ残します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と、%1 がスリットでミラーしたこの輪郭になります。&lt;kbd&gt;Shift&lt;/kbd&gt; で逆になります。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;離す&lt;/b&gt;と、垂直線でミラーした板ができます。&lt;kbd&gt;Shift&lt;/kbd&gt; を押すとこの側だけ残します。</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>青緑の線をたどると %1 にスナップします。&lt;kbd&gt;Ctrl&lt;/kbd&gt; を押すと離れます。&lt;kbd&gt;Shift+Enter&lt;/kbd&gt; で全体を使います。</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Shift+Enter: ガイド全体を使う</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>スリットがガイドに触れていないため、全体を使えるガイドがありません。</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>描けませんでした: スリットが %1 の外に出ていません。内側から縁をまたいでドラッグしてください。&lt;kbd&gt;O&lt;/kbd&gt; で穴を描き、&lt;kbd&gt;E&lt;/kbd&gt; で彫刻します。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>描けませんでした: 線が短すぎて何も囲めません。</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>描けませんでした: %1 より短い線は、ループになっていないかぎり手のすべりとみなします。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>描けませんでした: 線が行って戻っただけで、何も囲んでいません。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>描けませんでした: 線が自分自身と交差し、十分な大きさのループがありません。</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 はミラーされませんでした: 両半分がつながりません。</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>輪郭が自分自身と交差しているため、最大のループを残しました。</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 をミラーしました。軸を越えて戻った部分は除きました。</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 がスリットに届いていません: %2 と接合するものがありません。</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 はスリットの脇に描かれたため、つなぎを付け、地面で平らに切りました。</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 はスリットの脇に描かれたため、スリットまで届くつなぎを付けました。</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 は対称ではありません: 両半分が違っています。</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>矢印をドラッグして %1 を移動、輪で回転、四角で拡大縮小します。数値も入力できます。&lt;kbd&gt;Esc&lt;/kbd&gt; でハンドルを隠します。</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>ドラッグで動かします。&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を固定します。</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>ドラッグで回します。</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>ドラッグで拡大縮小します。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとこのまま決まります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 はロックされています。</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 をそこまで動かしたり拡大縮小したりできません。</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 の中で長さのわかるところに沿ってドラッグしてください。&lt;kbd&gt;Shift&lt;/kbd&gt; で 8 方向に固定します。&lt;kbd&gt;Esc&lt;/kbd&gt; で終わります。</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>その長さを入力してください。&lt;kbd&gt;Enter&lt;/kbd&gt; で %1 をその大きさにします。&lt;kbd&gt;Esc&lt;/kbd&gt; で線を消します。</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 には、板にできる大きさの平らな部分がありません: 先に大きくしてください。</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>平らな部分が %1 個を超えています: 面の数を減らしてください。</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>厚さ %1 のシートは折れません: %2 以下の材料を選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>筋入れの線に沿って折り、同じ番号の辺どうしをつないでください: つなぎ目 %n か所。</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>移動・回転する板をクリックするか、ドラッグしてください。&lt;kbd&gt;Esc&lt;/kbd&gt; でハンドルを隠します。</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>矢印をドラッグして移動、輪で回転、四角で拡大縮小します。数値も入力できます。&lt;kbd&gt;Esc&lt;/kbd&gt; でハンドルを隠します。</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>ドラッグで %1 を動かします。クリックで選択します。</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>ドラッグで動かします。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコピーを残し、&lt;kbd&gt;Shift&lt;/kbd&gt; で方向を固定します。</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>ドラッグで回します。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコピーを残します。</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>ドラッグで拡大縮小します。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコピーを残します。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとこのまま決まります。&lt;kbd&gt;Ctrl&lt;/kbd&gt; でコピーを残し、&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>離すとここにコピーを残します。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; でこのまま決まります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; で、1 つずつ先へずらしたコピーを %n 個作ります。&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>プリセットには名前が必要です。「=」や前後の空白は使えません。</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>ほかの人が調整できる変数がまだないので、残すものがありません。</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>「%1」というプリセットはありません。</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>これがほかの人に見える画面です。ファイルを保存して渡すと、この状態で開きます。</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>これを使っていた数値 %n 個は、ただの数値になりました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>ほかに何も設定しないプリセット %n 個も一緒になくなりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>モデルに問題が起きないような、もっと狭い範囲は見つかりませんでした。</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>動かすとビューが回り、離すと止まります。</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>動かすとビューがずれ、離すと止まります。</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>上へ動かすと拡大、下へ動かすと縮小し、離すと止まります。</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>変更していません: ここではできません。</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 はロックされています。変更するにはアウトラインでロックを解除してください。</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 は %2 が作ったものです: 元の板を編集するか、これを切り離してください。</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>%1 が何も残らなくなるため、元のままにします。</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 を地面で平らに切りました。</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 は地面で平らに切ると分かれたため、いちばん大きい部分を残しました。</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>貼り付けていません: コピーしたものに板も画像もありません。</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>コピーしていません: モデルはすでに対称です。</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>削除していません: 接合部は 2 枚の板が交わるところです。どちらかの板を削除するか、種類を「なし」にしてください。</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>「%1」は以前の内容に代わって、今の設定になりました。</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>まず板を描いてください: ミラーするものがまだありません。</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>まず板を描いてください: 繰り返したり分けたりするものがまだありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n 本の辺にフィンガーがありません: 板の交わる角度が浅すぎるか鋭すぎる、または辺が短すぎます。面の数を減らすか、スライスを使ってください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>選択したもののミラー像を追加します。&lt;kbd&gt;Enter&lt;/kbd&gt; でミラー、&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>片側を変えると反対側も変わります。&lt;kbd&gt;Enter&lt;/kbd&gt; でミラー、&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>一度だけ両側を同じにします。その後は別々に編集できます。&lt;kbd&gt;Enter&lt;/kbd&gt; でミラー、&lt;kbd&gt;Esc&lt;/kbd&gt; で中止します。</translation>
    </message>
</context>
<context>
    <name>Listing</name>
    <message>
        <source>, </source>
        <extracomment>between the entries of a list in a sentence, with its blank</extracomment>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>LoadPreset</name>
    <message>
        <source>Glass of water</source>
        <translation>コップの水</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>フォーク</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>ナイフ</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>スプーン</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>本</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>植木鉢</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>頂点のない面を 1 つ除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>頂点のない面を %n 個除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>頂点の位置が数値でない面を 1 つ除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>頂点の位置が数値でない面を %n 個除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>同じ頂点が 2 度ある面を 1 つ除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>同じ頂点が 2 度ある面を %n 個除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>重複した面を 1 つ除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>重複した面を %n 個除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>逆を向いていた面を 1 つ裏返しました。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>逆を向いていた面を %n 個裏返しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>表面に穴があります: 開いた辺が 1 本あります。</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>表面に穴があります: 開いた辺が %n 本あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>3 つ以上の面が集まる辺が 1 本あります。</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>3 つ以上の面が集まる辺が %n 本あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>面の向きをそろえられない辺が 1 本あります。</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>面の向きをそろえられない辺が %n 本あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>裏表が逆だったので、裏返しました。</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>切り口のすき間 1 か所を、なめらかな曲線で閉じました。</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>切り口のすき間 %n か所を、なめらかな曲線で閉じました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>面</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>方法</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 には mm やインチの大きさが書かれていません。端材は %2 × %3 mm とみなします。</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: 輪郭線が自分自身と交差しています。そのうち最大の部分、%2 × %3 mm を使います。</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: 線が端材を切り分けています。最大の部分、%2 × %3 mm を使います。</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: 端材の中に開いた線があります。閉じたときに囲む部分は空けておきます。</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>個数</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>すでにある板も数えます</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>X の間隔</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Y の間隔</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Z の間隔</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>配列</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>板を空間の直線に沿って繰り返します。</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>%1の配列</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>繰り返す板をクリックしてください。</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>ブレンド</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>板と板の間を補間します。</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>%1のブレンド</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>ブレンドする板を順にクリックしてください。</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>沿う板</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>沿わせる板をクリックしてください。</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>間ごとの枚数</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>緩急</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>均等</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>両端をゆっくり</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>対応</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>描いたとおり</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>逆順</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>繰り返し回数</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>成長</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>コピーの大きさ</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>大きさのばらつき ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>角度のばらつき ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>乱数の種</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>制限</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>枝分かれ</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>板とその上のすべてのコピーを、子の板の位置に次々と伸ばします。</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>%1の枝分かれ</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>根元</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>枝分かれさせる板をクリックしてください。</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>支える板</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>それを支える板をクリックしてください: コピーも同じように支えられます。</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>子の板</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>コピーに置き換える、付いている板をクリックしてください。</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>大きすぎる板を、つながり合うセルに分割します。</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>%1の格子</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>分割する板をクリックしてください。</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>シートに合わせる</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>セルの幅</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>セルの高さ</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>境目</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>直線（コネクタ付き）</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>ジグソーパズル</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>境目</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>境目ごとのコネクタ</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>コネクタの大きさ</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>クリアランス</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>統合する端切れの上限</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前方</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>後方</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>内側の深さを同じに</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>どのコピーも、同じ長さだけ相手の板に入ります</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>板を別の板に沿って一列に繰り返します。</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>%1の列</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>歯車</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>描いた扇形</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>分割数</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>外側の半径</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>内側の半径</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>丸</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>四角</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>台形</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>回転位置</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>%1の円</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>%1の星形</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1の穴</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>%1のロゼット</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>%1の歯車</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>放射形</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>板を円、星、歯車にするか、そうした穴をあけます。</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>形を変える板をクリックしてください。</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>繰り返す板をクリックしてください。</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>枝ごと</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>付いているものすべてと一緒に</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>繰り返し方</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>拡大縮小</translation>
    </message>
    <message>
        <source>No</source>
        <translation>しない</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>その場の太さで</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>板全体</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>スリットに沿って</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>縁との角度</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>一周</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>周回</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>板を別の板の輪郭の周りに繰り返します。</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>%1の扇</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>X に垂直</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>Y に垂直</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>Z に垂直</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>X と Y に垂直</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>X と Z に垂直</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>Y と Z に垂直</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>曲線に沿って</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>スライス</translation>
    </message>
    <message>
        <source>By</source>
        <translation>決め方</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>方向ごとの数</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>ずらし</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>すべての平面のずらし量（間隔に対する割合）</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>最小の断片</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>単位は mm²。これより小さいものと、全体に細いものは除きます</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>中空</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>輪郭に沿った壁だけを残します</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>メッシュを、その形に沿った板に切り分けます。</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>沿わせる輪郭の板をクリックしてください。</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>対象の板をクリックしてください。</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>モデル全体</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択部分</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>片側に描いたものを、すべて反対側にも繰り返します。</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>ミラーの面にする板をクリックしてください。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>板の平面</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>平面で接合</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>回転対称</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>一度描いたものを、すべて軸の周りに繰り返します。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>スリットが軸になる 2 枚の板をクリックしてください。</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>スリット</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>板に平行</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>Y のまわり</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>X のまわり</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>Z のまわり</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>基準の板</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>平行にする基準の板をクリックしてください。</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>%1&#x202f;mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1 はまだ何も作りません: 「%2」を選んでください。</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 が使っていた板「%2」が削除されました。別の板を選ぶまで何も作りません。</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 は何も作りません: 板が互いに交わっていません。</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 は何も作りません: 範囲内に場所がありません。</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 は分割するものがありません: 板が 1 つのセルに収まっています。</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 を計算できませんでした: 板が足りません。</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 は板 1 枚で止まりました。</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 は板 %n 枚で止まりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>支えるものがないため、%1 の板 1 枚を除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>支えるものがないため、%1 の板 %n 枚を除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 は何も作りません: 下絵がないか、そのファイルが見つかりません。</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 の小さな断片 1 個を除きました。</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%1 の小さな断片 %n 個を除きました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: 倍率 100% で印刷してください</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>シート %1、ページ %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>別ウィンドウにする</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <extracomment>keys, as they are labelled on a keyboard of the country, in menus: &quot;Ctrl+Shift+S&quot;</extracomment>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>スペース</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>←</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>→</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>↑</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>↓</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>中止しました: %1。モデルが変わると計算し直します。</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>計算できませんでした: %1。理由: %2。</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>問題の解決方法</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>%1を計算中…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>%1を計算中… %2%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>接合部とスリット</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>チェック</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>組み立て順</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>板がたわむときの強度</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>板の各場所の強度</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>スキン</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>シート上の板取り</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>磁石による下絵の変形</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>ぶつかり合う部品を外す方法</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>カットの設定</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>%1 を編集</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の材料を変更</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>板 %n 枚の材料を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 を挿入</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>地面に下ろす</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の台を広げる</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 に足を追加</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 と %2 を接合</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>%1 を %2 まで移動</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>板 %n 枚を %1 まで移動</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のスリットを反転</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 を %2 移動</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>組み立て可能にする</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を足で支える</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を地面まで伸ばす</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>板 %n 枚を地面まで伸ばす</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 の厚さを %2 にする</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を 90° にする</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の弱いところを広げる</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: スリットを反転</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: 合わせ位置 → %3%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 自動設定に戻す</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 種類 → 相欠き</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 種類 → 延長相欠き</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 種類 → ほぞ穴</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 種類 → ほぞ</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: 種類 → なし</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 を %2 で切り詰める</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を描き直す</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 に穴を描く</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を描く</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 を読み込む</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 をトレース</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の図形を変更</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>%2 に %1 を載せる</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のおもりを移動</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>おもりを %1 にする</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>おもりの名前を %1 に変更</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>おもりを取り除く</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を押す</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を押す力を移動</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を押す力を回転</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>押す力を %1 にする</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>押す力の名前を %1 に変更</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>押す力を取り除く</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の荷重を分散</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のコピーにも荷重をかける</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のコピーには荷重をかけない</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>下絵を %1 に引き寄せる</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>下絵を板 %n 枚に引き寄せる</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>下絵を %1 から離す</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>下絵を板 %n 枚から離す</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 にマークを付ける</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のマークを変更</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のマークを削除</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>モデルを %1% に拡大縮小</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を円にする</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を楕円にする</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の穴を円にする</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の穴を楕円にする</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の線をまっすぐにする</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の角を直角にする</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を縁から内側へ動かす</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 に点を追加</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の点を削除</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>%1 の点 %n 個を削除</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のハンドルを移動</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の輪郭を曲げる</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の点を移動</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>%1 の点 %n 個を移動</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の点を変更</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>%1 の点 %n 個を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を移動</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>板 %n 枚を移動</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を回転</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>板 %n 枚を回転</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を拡大縮小</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>板 %n 枚を拡大縮小</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 をコピー</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>板 %n 枚をコピー</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のコピーをミラー</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>板 %n 枚のコピーをミラー</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を直角にする</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>板 %n 枚を直角にする</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を軸にそろえる</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>板 %n 枚を軸にそろえる</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を別の板に取り付ける</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を独立させる</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>板 %n 枚を独立させる</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を取り付ける</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>板 %n 枚を取り付ける</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>%1 の追従方法を変更</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>板 %n 枚の追従方法を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 をロック</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>板 %n 枚をロック</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 のロックを解除</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>板 %n 枚のロックを解除</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>%1 をシート上で移動</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>%1 をピン留め</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>部品 %n 個をピン留め</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 のピン留めを解除</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>板 %n 枚のピン留めを解除</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>すべての部品のピン留めを解除</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>%1 の回転を変更</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>板 %n 枚の回転を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を対称に保つ</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>板 %n 枚を対称に保つ</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の両半分を別々にする</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>板 %n 枚の両半分を別々にする</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を追加</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を取り除く</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を変更</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を移動</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を回転</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を拡大縮小</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>%1 と %2 をそろえる</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を隠す</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>下絵 %1 を表示</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 の板 %n 枚を提案</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 を多面体にする</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 を展開</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>%1 を追加</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>%1 を設定</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>%1 の名前を %2 に変更</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a section
----------
%1 is the name of a number
----------
%1 is the name of an operation</extracomment>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>プリセット %1 を残す</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>%1 に設定</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>プリセット %1 を削除</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>調整用に配布</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>設計を編集</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>変数を設定</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>範囲を狭める</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>%1 の名前を変更</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>板 %n 枚を削除</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <extracomment>%1 is the name of an operation, %2 of what it works on (&quot;Along&quot;), %3 of a section</extracomment>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <extracomment>%1 is the name of an operation, %2 of a number (&quot;Count&quot;), %3 and %4 what it was and is</extracomment>
        <translation>%1: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Change %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 を変更</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 の順番を変更</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 を除外</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>板 %n 枚を除外</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>除外した板を戻す</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を切り取る</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>板 %n 枚を切り取る</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 を貼り付け</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>板 %n 枚を貼り付け</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>寸法を残す</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>寸法を削除</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>対称にする</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 をオンにする</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 をオフにする</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 を板に変換</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 を切り離す</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の穴をなくす</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>板 %n 枚の穴をなくす</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>%1 の平面をずらす</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>%1 の平面数を変更</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>%1 の平面の間隔を変更</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 は、厚さ %2 の板を作るには小さすぎるか細すぎます。</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 には、互いに支え合って自立する板が見つかりませんでした。</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 には、今ある板の間に収まる板がほかに見つかりませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 の板は %n 枚しか見つかりませんでした: それ以上は互いのじゃまになるか、支えがありません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>自立することが確認できた %1 の板は、最少で %n 枚です。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>板が平らな足で立つように、%1 を地面に %2 沈めました。</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>板が立つように、%1 を地面に %2 沈め、高さ %3 までの足を付けました。</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>動く画像です。最初の 1 枚だけを表示します。</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>テキスト %n 個を除きました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>画像 %n 個を除きました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>数値か名前か式が足りません。</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>式は %1 文字までです。これは長すぎます。</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>「%1」で、式の数値・名前・記号が %2 個を超えます。</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>「%1」で、かっこや符号の入れ子が %2 段を超えます。</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>「%1」はここでは読み取れません。</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>「%1」の後に何か足りません。</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>「%1」の前に何か足りません。</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>「%1」と「%2」の間に、+ や * などの記号が足りません。</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>「%1」のかっこが閉じていません。</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>「%1」の後に、閉じかっこが 1 つ余分にあります。</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>「%1」の文字列に、終わりの引用符がありません。</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>「%1」は 1 つの数にも 2 つの数にも読めます: 小数点はピリオドで書くか、コンマの後に空白を入れてください。</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>「%1」は単位です。前に数値が必要です。</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>「%1」は 2 通りに読めます: 「%2」をかっこで囲んでください。</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>「%1」は 2 つ目の比較です。2 つをつなぐには and(…; …) を使ってください。</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>「%1」という関数はありません。</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>「%1」のかっこの中は %2 個です（今は %3 個）。</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>「%1」のかっこの中は %2 個以上です（今は %3 個）。</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>「%1」のかっこの中は %2 個以下です（今は %3 個）。</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>「%1」という変数はありません。</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>「%1」は材料の厚さですが、ここには材料が 1 つに決まっていません。</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>「%1」は%2なので、単位を付けられません。</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>「%1」は%2、「%3」は%4です。足したり比べたりできるのは同じ種類どうしだけです。</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>「%1」は%2なので、計算に使えません。</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>「%1」は%2ですが、ここに必要なのは%3です。</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>「%1」は%2なので、累乗は 2 のような小さな整数だけです。「%3」乗はできません。</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>「%1」は長さ・角度・質量を掛けすぎています。</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>「%1」は%2なので、平方根がありません。</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>「%1」は 0 です。0 で割ることはできません。</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>「%1」は負の数なので、平方根がありません。</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>「%1」の正接は無限大です。</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>「%1」は −1 から 1 の間にないので、対応する角度がありません。</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>「%1」は 0 より大きくないので、その刻みに丸めることはできません。</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>「%1」は大きすぎます。</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>「%1」は %2 で、整数ではありません。round、floor、ceil で整数にできます。</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>「%1」は %2 です。%3 以上にしてください。</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>「%1」は %2 です。%3 以下にしてください。</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>「%1」は「%2」ですが、選択肢にありません。</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>「%1」の文字列は %2 文字を超えます。</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>この変数は自分自身から計算されています: %1。</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>この変数は「%1」から計算されますが、今その値がありません。</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>「%1」という変数が 2 つあります。</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>「%1」は名前に使えません。名前は文字で始まり、文字・数字・_ からなる %2 文字以内です。</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>「%1」は式の中で意味があるため、名前に使えません。</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>この変数はもうありません。</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>「%1」の波かっこが閉じていません。</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>ただの数</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>はい・いいえ</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>長さ・角度・質量・ただの数のどれでもないもの</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>板 %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>板 %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 と %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>「%1」という材料はありません。ファイルの材料、または Birch plywood、Acrylic、Card など材料一覧にあるものを選んでください。</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 では材料 %2 のスリットがなくなります: クリアランスは %3 mm です。</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 は、厚さ %3 mm の材料 %2 に合いません。</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>%1 ファイル</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>%2 の %1 ファイル</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 または %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1、または %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>使い方: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>このヘルプを表示します。</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>ファイルが指定されていません。</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>ファイルが多すぎます: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>モデルの名前付き変数の値、またはプリセットが設定するすべての値を変えます。繰り返し指定できます。</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>すべての材料の厚さ。</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>すべての板を、この材料または .fff ファイルの材料からカットします。</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>加工機が削り取る全幅。</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>スリットに加えるクリアランス。0 未満ならきついはめ合いになります。</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>ファイル内で修正したものそれぞれについて、その場所を示します。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: 「%2」が見つかりました（必要: %3）。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: 「%2」が見つかりました（必要: %3 から %4 の数値）。</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: 「%1」が見つかりました（必要: mm 単位の幅 x 高さ。例: 600x400）。</translation>
    </message>
    <message>
        <source>--set: %1</source>
        <translation>--set: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a file&apos;s name, %2 a sentence about what is in it
----------
%1 are names of stocks, %2 is a sentence</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Push all %1 slats together: what their width is less than %2 mm, divided by %1, is the kerf.</source>
        <translation>細板 %1 枚をすべて寄せます: 幅が %2 mm より足りない分を %1 で割ると、切断幅になります。</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>各部品をシートに残すブリッジの数と mm 単位の幅（例: 3:0.4）（なし）。</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>各カットを、線から端材側へこれだけ離れたところで始めて終えます（0）。</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>重なり合う 2 つの部品の辺を一度だけカットします（--spacing 0 のとき）。</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>部品の代わりに試験片を書き出します: 番号付きの幅のスリットと、切断幅のわかる細板です。</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: 「%1」が見つかりました（必要: 0 から %2 の数値、コロン、%3 から %4 の幅）。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: 「%2」が見つかりました（必要: 0 から %3 の数値）。</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>手順 %1: 部品 %2 から始める</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>手順 %1: 部品 %2 から別のまとまりを作り始める</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>手順 %1: 部品 %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>手順 %1: 部品 %2 をひとまとめにして、手順 %3 と %4 で組んだものをつなぐ</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>板: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>接合部: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 と %2 は交わっていますが、差し込めるスリットがありません。</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>すべての板がつながっています。</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 の一部</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>ほかとつながっていません: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>大きさ %1 × %2 × %3 mm（幅、高さ、奥行き）</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>質量 %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>材料 %1、%2 mm、%3 のシート</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>部品 %1: %2、%3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>、接合部 %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>カットするものがありません: モデルに板がありません。</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>カットするものがありません: どの板もスリットで切ると何も残りません。</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>-o がありません: 書き出すファイルを指定してください。</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: ファイルには名前が必要です。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: この種類のファイルは書き出せません（必要: %2）。</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>メッシュ、画像、図面（SVG）を、最大寸法をこの mm にしてモデルの脇に置きます。繰り返し指定できます。</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: 「%1」が見つかりました（必要: ファイル、またはファイルと mm 単位の大きさ。例: ball.stl@80）。</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>書き出す .fff ファイル（- は標準出力）。</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>メッシュの最大寸法をこの大きさにします。なければファイルのとおり、それもなければ 254。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: 「%2」が見つかりました（必要: %3 から %4 の整数）。</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: この図形は帯より大きいです。</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>長さ: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>密度: %1%</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>部品: %1、シート: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm、%3: 部品 %4 個、%5% を使用</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: シートより大きい部品があります。</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: 「%1」が見つかりました（必要: groups または files）。</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: 「%1」という加工機はありません（必要: %2、または .json ファイル）。</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files には名前が必要です: 標準出力は 1 つのファイルです。</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>スリットの描画幅は %1 mm です。</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>スリットの描画幅は %1 mm です（%2 − 切断幅 %3）。</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>以前の書き出しのシートが残っています: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>パッチ: %1、三角形: %2。</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>開いたままのところ: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: カット長 %2 m、約 %3 分。</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>シートが加工エリア %1 x %2 mm より大きいです。--sheet で別のシートを選んでください。</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>部品: %1、シート: %2、%3% を使用。</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>書き出すファイル（- は標準出力）。</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1。ファイル名からわからない場合に必要です。</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>シートの脇の 100 mm の目盛りを省きます。</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>シートの縁からいちばん近いカットまで（5）。</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>隣り合うカットの間（2）。</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>90° 単位の回転だけ（木目のあるシート用）。</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>部品を実際の輪郭で並べ、この秒数だけ探します。0 なら最初の板取り（外接長方形による）を使います。</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: シートごとのグループを持つ 1 つの SVG。files: OUT-1.svg、OUT-2.svg など（groups）。</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>カットする加工機（色、速度、G-code 用）: %1。または独自の設定の .json ファイル（generic）。</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>ソリッドの代わりに、板が表す形を面として書き出します（%1）。</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>-o - には形式が必要です: --format %1。</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: この種類のファイルには入りません（必要: %1）。</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: この種類のファイルには入りません（必要: %1）。</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>画像のピクセル数（1280x800）。</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 から iso4、front、right、top、left、back、bottom、または fit: もう一度正面（iso1）。</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: 「%1」が見つかりました（必要: %2 以下のピクセル単位の幅 x 高さ。例: 1280x800）。</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: 「%1」が見つかりました（必要: %2 のいずれか）。</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>自立します。</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>倒れます。</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>倒れます: 支えが一直線しかありません。</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>一部が何にも載っていません。</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>地面に載っていません。</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>地面の上をすべります。</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>部品どうしが動いてしまいます。</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>耐えます。</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>ぎりぎり耐えます: 角にひびが入るおそれがあります。</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>折れます。</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>接合部が抜けます。</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>強度を計算できるのは、静止しているものだけです。</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>判定できません: 強度のわからない材料があります。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>耐えるかどうかを計算できませんでした。</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>%1、自立するはず。</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>弱すぎます: もちますが、必要な安全率に足りません。</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>%1、耐えるはず。</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 が地面を %2 N で押しています。</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>接合部 %1–%2 は %3 N で引き抜かれます: 接着するか、スリットを反転してください。</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>%1 のたわみを計算できなかったため、たわまないものとして扱います。</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>板のたわみを計算できなかったため、たわまないものとして扱います。</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>接合部の荷重の分け方が一通りに決まりません（不静定、%1）。最悪の分け方で判定します。</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>%1 の応力を計算できませんでした。</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 は判定できません: 材料の強度がわかりません。</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>%1 N の押す力が %2 の材料から外れているため、いちばん近いところで受けています。</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>おもり %1 が %2 の材料から外れているため、いちばん近いところで受けています。</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>合計 %1</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>合計 %1 N</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>荷重の %1 倍</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>いちばん弱いのは %1: くびれで材料の強度の %2、角で %3。</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>%1 mm たわみます。最大は %2 です。</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>%1 からひびが入るおそれがあります。</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>%1 で折れます。</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>載っているものも含めた重さは %1 N です。</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>「%1」が見つかりました（必要: 名前=値。例: width=400）。</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>「%1」が見つかりました（必要: width=400 のような 名前=値、またはプリセット: %2）。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>「%1」は %2 とも %3 とも読めます。どちらかで書いてください。</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>モデルに名前付きの変数がありません。</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>「%1」という変数はありません（必要: %2）。</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>ほかの人が調整でき、範囲があり、使われている変数がありません。</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>試したもの: 範囲の端の組み合わせ %2 通りのうち %1 通り、その間の %3 通り。</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>すべて合格です。</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%2 通りのうち %1 通りが不合格:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>場所:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>面: %1、シェル: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>平面がメッシュを切っていません。</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>穴: %1 mm²、点 %2 個</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>ループ: %1 mm²、点 %2 個</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>面積: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>平面上の 1 点と法線（コンマ区切りの 6 つの数値）。</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>先にメッシュの最大寸法をこの大きさにし、地面に置きます。</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>ほかのプログラム用に JSON を出力します。</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>--plane がありません。</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: 「%1」が見つかりました（必要: 6 つの数値。後の 3 つは方向）。</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>板の交わる角度が 30° 未満または 150° 超で、フィンガーを付けられません: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>一方の板が他方を通り過ぎるか届かないため、フィンガーを付けられません: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>3 つのフィンガーを付けるには短すぎる辺です: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>厚さ %1 mm のシートは折れません（上限: %2 mm）。--stock で別の材料を選べます。</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: 平らな部分が %2 個あります（上限: %3）。--faces で減らせます。</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: 板にできる大きさの平らな部分がありません。--size で大きくできます。</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>展開図: %1、折り線: %2、つなぎ目: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>先にメッシュをこの数の三角形まで単純化します。同じ平面にあるものは 1 枚になります。</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>平らな板の代わりに、厚さ 3 mm までのシートを筋入れの線に沿って折る展開図にします。</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>--unfold のときののりしろの幅。厚さ 1.5 mm までのシートでは 8 mm、それより厚ければ 0 mm。</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap は --unfold のときに使います。</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>小さすぎて板にできない部分: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>板: %1、接合部: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>探す時間（10）。0 なら最初の板取りを使います。</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>数値を変えると別の板取りになり、同じ数値なら同じになります。</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>部品の回転: none、180、90、free。</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>シートの縁からいちばん近いカットまで。</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>隣り合うカットの間。</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: 「%1」が見つかりました（必要: none、180、90、free のいずれか）。</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>このモデルにオペレーションはありません。</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>板 1 枚</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>ほかのプログラム用に JSON を出力します。手順は 0 から数えます。</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>弦と曲線の距離の上限（0.01）。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: この種類のファイルは書き出せません（必要: .png）。</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: 「%1」が見つかりました（必要: labels、checks、stress、forces、skin、またはコンマ区切りで複数）。</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: 力は表示しません。自立しないか、計算できませんでした。理由は「check」でわかります。</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>書き出す PNG ファイル（- は標準出力）。</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: 板の名前。checks: 問題のある板を縁取ります。stress: いちばん弱い断面。forces: 足と接合部にかかる力。skin: 板が表す形。</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>有限要素法による応力を、板全体に色で表示（数秒かかります）。</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>画像には OpenGL 3.3 の使えるディスプレイが必要ですが、ありません。</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>画像を PNG ファイルに書き出せませんでした。</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>もとにするモデル。なければ新しいモデル。</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: 「%1」が見つかりました（必要: X、Y、Z、XY、XZ、YZ、radial のいずれか）。</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>--count と --spacing の両方が指定されました（必要: どちらか一方）。</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: 軸の周りの平面には間隔がありません（必要: --count）。</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>平面を垂直に並べる軸: X、Y、Z、2 つ組み合わせて格子、または radial で垂直軸の周り（XZ）。</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>方向ごとの平面の数（6）。</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>平面から平面まで。</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: 板にできる大きさの形を切り取る平面がありません。</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size は .png 用です。PDF の大きさは用紙で決まります。</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper は .pdf 用です。</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: 「%1」が見つかりました（必要: a4 または letter）。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>手順 %1/%2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 または letter（指定がなければ、お使いの国の標準）。</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>板の枚数（8）。</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>数値を変えると別の板になります（1）。</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>プリセット: %1。現在は %2 です。</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>プリセット: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>モデルに名前付きの変数がありません。</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>ほかの人が調整できる変数の範囲を試します。</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>数値を変えると別のところを試し、同じ数値なら同じところを試します。</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>名前よりセルの数が多くなっています。</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>CSV ファイル: 変数の名前と、バリエーションごとに 1 行の数値。</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>書き出し先のフォルダー。なければ作ります。</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>それぞれについて書き出すもの（svg）。</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table と -o の両方が必要です。</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: 「%1」が見つかりました（必要: カットデータの種類）。</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: 数値の行がありません（必要: 名前の下に 1 行）。</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: 引用符が閉じていません。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: フォルダーを作れません。</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>板の中央、または mm 単位の X,Y におもりを載せます: 「Rib 4=350g」、「Rib 4@10,25=0.35kg」。繰り返し指定できます。</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: 「Rib 4=350g」のように 名前=質量 が必要です。</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: = の後に 0 より大きく 1000000 kg 以下の質量が、g、kg、oz、lb のいずれかで必要です。</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: 「%2」という板はありません。</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: 「%2」はスリットで切ると何も残りません。</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: &quot;%2&quot; という名前の列が 2 つあります。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: この種類のファイルは書き出せません（必要: .pdf、.html または .png）。</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size は .png 用です。ウェブページは画面に合わせて表示されます。</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>手順の画像を作れませんでした。</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>全手順の PDF ファイル（- は標準出力）、OUT.html でモデルを回して見られるウェブページ（スマートフォンでも可）、または OUT.png で OUT-01.png、OUT-02.png など。</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: 材料 %1 の端材が多すぎます。</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>%1 の足りないシート: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>手順はファイルに含まれていません: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>%1 のシートは余白 %2 mm の内側に場所がありません。</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: 「%1」が見つかりました。300x200 のような幅 x 高さ (mm)、または .svg ファイルと、その後ろに :2 のような枚数が必要です。</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>シートのサイズ (例: 600x400)。後ろに :N を付けると枚数。</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: モデルに材料「%2」はありません。モデルは %3 からカットします。</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: モデルは %2 からカットします。「%3=%1」のように、どの材料の端材かを指定してください。</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>ほかの大きさのシート、または残ったシート（実寸の .svg ファイルのいちばん大きな輪郭線）。新しいシートより先に使います。後ろに :N を付けると、その枚数になります。材料が複数のモデルでは、「Birch plywood=300x200」のように材料の名前を前に付けます。繰り返し指定できます。</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>輪郭に沿った部分と、ほかの板が交わる部分に、この幅の壁だけを残します。</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>接合部ごとに、両方の部品で同じ、それぞれの色で番号を彫刻します。</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: この種類のファイルには入れられません。%1 が必要です。</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>2 つの部品で共有して一度だけカット: %1 mm。</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>2 つの部品で重なる辺がないため、一度だけカットするところはありません。--spacing 0 なら直線の辺を重ねられます。</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>スリット %1 から %2 のクリアランスは %3 から %4 mm です: 帯を差し込み、合ったスリットのクリアランスを材料に設定してください。</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>すべてのカットのリードを入れる場所がありません: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>FlatFitFab について</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>ライセンス</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>不具合の報告用</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>平らな部品を 3D で描き、組み合わせをその場で確かめて、カットします。アカウントは不要で、データがこのコンピューターの外に出ることはありません。</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>J. McCrae、N. Umetani、K. Singh による「FlatFitFab: Interactive Modeling with Planar Sections」（UIST 2014）に基づいています。GNU General Public License バージョン 3 以降のフリーソフトウェアです。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>このプログラムに使われているもの</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>ライセンスの本文</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>このプログラム</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>ウィンドウ、ファイル、文字</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>厳密な幾何計算</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>ベクトルと行列</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>輪郭線の切り取りとオフセット</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>図面の読み込み</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>図面の展開</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>画像とメッシュのあるモデル</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>CGAL が使う部品</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>丸めのない数</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>桁数の多い数</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>エラーになりうる結果</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>手順のウェブページのモデル表示</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>板</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>オペレーション</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>チェック</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>視点</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>平面に描く</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>板の上に描く</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>調整用ツールバー</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>たった今</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n 分前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n 時間前</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>昨日</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n 日前</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>変更前の結果</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: 変更前の結果</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>判定</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>耐荷重</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>たわみなし</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>その板がありません</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>今の状態では自立しません</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>今の状態では折れます</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>強度が不明</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>計算中… %1%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>計算できませんでした</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>描画ツールの数値</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>手前</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>コピー数</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>変更前の結果</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Tips only past 12°.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>問題</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1（%n か所）</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1/%2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>チェック</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>最初の板を描くとチェックが始まります。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>チェック中…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>変更前の結果</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>チェックする板がまだありません。</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>問題はありません。</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>まだチェック中です。今のところ問題はありません。</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>問題 %1/%2: %3。</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>まだチェック中です。結果がわかり次第、実行します。</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>モデルが変わったため、これはもうできません。</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>実行しました: %1。</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>クリックすると: %1。</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>問題 %1/%2、箇所 %3/%4: %5。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>書き出し先</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>したいことを入力</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>該当するコマンド</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>該当するコマンドなし</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>別の言葉で試してください</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>テストピースを書き出す</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 テストピース</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>テストピースを %1 に書き出しました。カットして、スリットに帯を差し込んでください。書き出しのときに、合ったスリットを選べます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: クリアランスなし</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: %2 狭い</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: %2 広い</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>ブリッジ</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>各部品のカットにこの数だけ短い切り残しを入れ、シートに留めます。0: なし</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>ブリッジの幅</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>リードイン</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>各カットを、線から端材側へこれだけ離れたところで始めて終えます。0: 線の上</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>一度だけカット</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>共有する辺</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>間隔が 0 で隣り合う部品の辺です</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>テストピースの番号付きスリットのうち、シートを最もよく保持するもの（「ファイル」メニュー、または工房用一式からカットします）。クリアランスを設定します。</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>合ったスリット</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>約 %n 分</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>寸法</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>寸法 %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>この長さを変えるとモデル全体が拡大縮小します</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>この長さを変えると、%1 の 2 点間が伸び縮みします</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>この寸法を削除</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>モデルを開く</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>モデルを挿入</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>図面を読み込む</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>下絵を追加</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>挿入していません: %1 に板がありません。</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>モデルを保存</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>保存していない変更</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>%1 の変更を保存しますか？</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>保存しないと失われます。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>保存した状態に戻す</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 を保存した状態に戻しました。「元に戻す」で変更を取り戻せます。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 を開いています…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>別のファイルを選ぶ</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>一覧から外す</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 を保存しています…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>別の場所に保存…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>ディスク上で変更</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 がほかのプログラムで変更されました。</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>上書きすると、その変更が失われます。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>上書き</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>無題</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>板ごとの対称</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>スリットの片側だけに描いた輪郭を、反対側にミラーします。描いている間に Shift を押すと逆になります。</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>最初の板もミラー</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>最初の板も、描き始めの点を通る垂直線でミラーします</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>地面で切る</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>地面で平らに切る: 地面より下に描いた部分を除きます</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>スナップ</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>点、補助線、地面、グリッドにスナップします</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>ビューの回転角</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>90° では新しい平面を真正面から見ます。小さくすると、描き始めた板も見えたままになります</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>回転時間</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>新しい板の平面にビューが向くまでの時間です</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingPage</name>
    <message>
        <source>A hole, while you draw it</source>
        <translation>描いている途中の穴</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>描いている途中の新しい輪郭</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>描いている途中の新しい板</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>次は輪郭です</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>スリット</translation>
    </message>
    <message>
        <source>On</source>
        <translation>取り付け先</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>自身のスリット</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>曲線の数</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>ほぞ</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>閉じている</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>上に開く、深さ %1</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>下に開く、深さ %1</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>横に開く、深さ %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;ミラーなし。&lt;/b&gt; 両半分がスリットでつながりません。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;ミラーなし。&lt;/b&gt; 軸の片側に描かれています: 一方に %1、他方に %2。対称がオフか、Shift が押されています。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;ミラーあり。&lt;/b&gt; 軸の片側に描かれています: 一方に %1、他方に %2。両側を自分で描くには、軸を %3 以上越えてください。</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>新しい板</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>沿う下絵</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>ガイド上</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>一筆の %1%</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>最大のずれ</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>変数で決められる数値は、一度に 1 つだけです。</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>この数値は変数で決められません。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>なし。除外または切り離すには、板を 1 枚クリックしてください。</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>再び表示</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>No. %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1（除外）</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1（切り離し）</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>カットデータの書き出し</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>書き出し後にフォルダーを開く</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 のスキン</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1（ソリッド）</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1、%2 · カット長 %3</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>それでも書き出す</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>板取り中…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>変更…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 以降（%2 の中）</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1（%2 の中）</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>%2 の %1 を置き換えます</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>ホームフォルダー</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>シート %1/%2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>部品リスト</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>前のシート（PageUp）</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>次のシート（PageDown）</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>シート全体を表示</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>スキンにシートはありません: ファイルには、板が表す形が輪郭を覆う面として入ります。</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>ソリッドにシートはありません: ファイルには、スリット付きの組んだ状態のモデルが実寸で入ります。</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>シート %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>カットするものがありません。</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>使用率: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>部品をシートに配置しています…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>どの材料？</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>測り直す</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>実測の厚さ</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>カットするシートの厚さをノギスで測ってください: スリットがそれに合わせて描かれます。</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>どのシート？</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>シートの幅</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>シートの高さ</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1、厚さ %2</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>自由なサイズ</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>どの加工機ですか?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>この加工機とそのプログラムが使う色、レイヤー、速度、G コードと、各材料から削られる幅</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1、実測 %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>実測した値です</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>先に端材 %n 枚を使います。</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>一般のレーザー</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>端材に載る部品はありません。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>端材 %n 枚のうち %1 枚を先に使います。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1（%2 件）</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>カットできない</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>チェック中…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>注意することはありません。</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>%1 のシートは余白 %2 の内側に場所がありません。</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>%1 の切断幅が 0 です: 機械が削る分だけ、スリットは広く、部品は小さくなります。</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>シートが %1 の加工範囲 %2 より大きいです。小さいシートを選んでください。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>はめ合い</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>切断幅（全幅）</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>クリアランス</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>スリットの描画幅</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>板取り</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>縁の余白</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>木目のあるシートでは 90° 単位</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm、シートの下</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>確認用の目盛り</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>シートの脇に描かれ、カットはされません: 加工機で測って大きさを確かめてください</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>カット</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>自由な角度</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>90° 単位</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>180° 単位</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>描いたとおり</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>この材料と選ばれた加工機について保存されます</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>接合部ごとに色を変える</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>接合部の番号</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>接合する 2 つの部品の番号を同じ色にします。紙に印刷するとき、または色ごとに動作を決める加工機で使います</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>迷ったら、まずテストピースをカット…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>%1 はスリットで切ると何も残らず、カットされません。</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 はシートより大きいため、専用の大きさのシートに置きます。</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 は細すぎて番号を入れられません。</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 に切断幅より細い穴か切り込みがあり、カットされません。</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 には、すべての接合部の番号を入れる場所がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>部品 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>シート %n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 を書き出しています…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>%1（%2）を %3 に書き出しました。</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>%1（%2）を %3 に書き出しました。スリットの描画幅は %4 です。</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>%1（%2）を %3 に書き出しました。スリットの描画幅は %4 です（%5 − 切断幅 %6）。</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>%1 をソリッドとして %2 に書き出しました。</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>スキンを %1 に書き出しました。%n か所は開いたままです。</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>スキンを %1 に書き出しました。</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>別の場所に書き出す…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>以前の書き出しのシートが残っています: %1。</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>書き出していません: もとのファイルはそのままです。</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>%1 のシートがあと %n 枚足りません。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>数値が足りません。</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>「%1」はここでは読み取れません。</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>「%1」の後に何か足りません。</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>かっこが閉じていません。</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>閉じかっこが 1 つ余分にあります。</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>0 で割ることはできません。</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>「%1」という変数はありません。</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>これは長さになりません。長さにはただの数を掛けてください。</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>これは質量になりません。質量にはただの数を掛けてください。</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>「t」は材料の厚さですが、ここには材料が 1 つに決まっていません。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%2 の %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>何も開いていません: ファイルが指定されていません。</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 はモデルではありません。FlatFitFab で開けるのは %2 です。</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>%1 を開けませんでした: %2 にもうありません。何も変更していません。</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>%1 を開けませんでした: %2。何も変更していません。</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>%1 を開けませんでした: %2（%3）。何も変更していません。</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>ディスク上のファイルは元のままです。</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>何も書き込んでいません。</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>フォルダー %1 がありません</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>書き出せませんでした: %1。%2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>%1 を保存できませんでした: %2。%3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>図形</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>点を 1 つ動かすと手描きになります</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>板の座標での中心です</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>穴 %1</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Free form</source>
        <translation>自由な形</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>カットデータ</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>紙または画像</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>3D プリントやレンダリング用のソリッド</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>部品リスト</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>工房用一式</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>どのファイル？</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>用途は？</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>シートごとに 1 ファイル</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>トレース</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>置く面</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>地面に寝かせます</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>正面から見えるように立てます</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>右から見えるように立てます</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>選択した板の上に置き、一緒に動くようにします</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>裏返し</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>裏から見た向きにします</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>2 枚をそろえる</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>最後の 2 枚の画像を、同じ物の正面と側面とみなし、高さと位置をそろえます</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>どれだけ濃いところをトレースするか</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>なめらかさ</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>角をどれだけ丸めるか</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>輪郭線</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>板を作る</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>輪郭線から、その平面に板を作ります</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>穴をあける</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>下にある板、または選択した板に穴をあけます</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>彫刻</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>下にある板、または選択した板に線を描きます</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: 板には多すぎます</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>抜ける、%1 N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>接合部 %n か所が抜ける、最大 %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>モデル (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>図面 (%1)</translation>
    </message>
</context>
<context>
    <name>fff::ui::GizmoMarks</name>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <extracomment>the way to the right, along an arrow</extracomment>
        <translation>右</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>上</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>手前</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Copy: %1</source>
        <translation>コピー: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>キー一覧をページとして保存</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF 文書 (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>FlatFitFab のキー</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 を書き込めませんでした。</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>すべての操作です。選ぶとその時点に戻ります。</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>すべての操作がここに並び、どの時点にも戻れます。</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>最初に戻りました。後の操作をクリックするとやり直せます。</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>モデルは「%1」の直後の状態です。</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>開いたときの状態</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>新しいモデル</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>ここで保存</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Delete で板を外します。ドラッグ、または Alt+矢印キーで順番を変えます。</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1（削除済み）</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選ぶ…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is what an operation works on (&quot;Along&quot;), %2 the name of a section</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::InstanceGroup</name>
    <message>
        <source>Made by an operation</source>
        <translation>オペレーションで作成</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>作成元</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>鏡像の元</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>これを除外</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>切り離し</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>これを描いた板に変えます。ほかの板は引き続きオペレーションが作ります</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>元の板</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>1 枚への変更がすべてに反映されます</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>描き直すと、これから作られたものがすべて変わります</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>接合部</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>スリット</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>自動設定に戻す</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>開く側</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>スリットを反転</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>スリット</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>合わせ位置</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>ほぞ、幅 %1</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>閉じている、長さ %1、幅 %2</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>深さ %1、幅 %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 と %2 が重なっています。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 を切り詰める</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>合わせ位置 %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>深さのうち %1 のスリットが受け持つ割合です。残りは %2 のスリットになります</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>手動で設定しています。自動では 50% です。%1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>板: %1 と %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>手動で設定しています。自動設定に戻せます</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 の開く側</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>%1 のスリットが開く側です。%2 のスリットは反対側に開きます</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>%1 のスリット</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>種類、向き、合わせ位置を、またプログラムに任せます</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>この接合部に手動の設定はありません</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>%1 との接合部を選択</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>まだなし</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>相欠き</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>延長相欠き</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>ほぞ穴</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>ほぞ</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>接合なし</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>相欠き</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>延長相欠き</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>ほぞ穴</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>ほぞ</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>材料のクリアランスのため、スリットの幅がなくなります</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>スリットを外側へ開けません: 穴がじゃまになっています</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>一方のところでは片方の向きにしか、もう一方のところでは逆の向きにしか動けません</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>固定するものがありません: スリットが始まるところに穴があります</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>どちらに差し込んでも、一方の板が他方からはみ出します</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>どちらの板も他方からはみ出していません</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>2 か所以上で交わっています</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>どちらの板も、他方の閉じたスリットを通れません</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>一方の板が他方で終わっているだけです</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>どちらの板も他方の面で終わっていません</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>ほぞとそのスリットを入れる場所がありません</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>交わる角度が 30° 未満です</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>手前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>奥</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>キーを押してください</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>印刷用のページとして保存…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>ビューの中で</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>最初の板を描く</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>真ん中でドラッグ</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>ほかの板を横切る板を描く</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>外へドラッグして続ける</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>ビューを回す</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>モデルの横でドラッグ</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>近づく</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>ビューを動かす</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>中ボタンでドラッグ</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択する</translation>
    </message>
    <message>
        <source>click</source>
        <translation>クリック</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>まとめて選択する</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Shift とドラッグ</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>できることを見る</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>右クリック</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>点を追加する</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>輪郭をダブルクリック</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>スナップせずに描く</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>Ctrl を押したまま</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>板取り</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>余白</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>穴の中の部品</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>大きい部品の穴の中に小さい部品を置けるようにします</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
</context>
<context>
    <name>fff::ui::LibraryDock</name>
    <message>
        <source>Part</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>選択を追加</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>選択部分をライブラリに追加します。選択がなければモデル全体を追加します</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダー…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>ここに表示するモデルのフォルダーを選びます</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>残した部品がここに並びます: 板を選択して「選択を追加」をクリックしてください。</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>ライブラリのフォルダー</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>追加していません: まだ何も描かれていません。</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>ライブラリのフォルダー %1 を作れません。</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 をライブラリに追加しました。</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 をごみ箱に入れました。</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>%1 をごみ箱に入れられませんでした。</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>モデルに追加</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>ごみ箱に入れる</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>おもり</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>押す力</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>かかるところ</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>ただのおもり</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>kg、oz、lb も使えます: 1.5 kg、2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>中の水</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>重心</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>置いたところからの高さです: 高いほどモデルが倒れやすくなります</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N は、およそ 1 kg の重さです</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>方向 X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>方向 Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>方向 Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>対象の板</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>板の平面内での、原点からの位置です</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>位置 X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>位置 Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>1 点に</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>面に</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>縁に沿って</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>吊り下げ</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>コピーにも</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>オペレーションが作る板のコピーにも、それぞれかかります</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>おもりと押す力</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 で名前を変更、Delete で取り除きます。</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>おもり</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>押す力</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>押す力</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>おもり</translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>fff::ui::MagnetGroup</name>
    <message>
        <source>Template</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>引き寄せる</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>ほかの板のガイドが描いた形に沿うように、下絵をこの板の平面へ曲げます</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>届く距離</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>ツールバー</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>板を繰り返し、ブレンドします</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>モデルを表示できません: グラフィックスドライバーが OpenGL 3.3 に対応していません。新しいドライバーで解決することがあります。</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>このディスプレイではモデルを表示できません。</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>新しいモデルを始めるか、続きを開くか、サンプルを見てみましょう。</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>復元したモデル: 未保存のもの %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>表示する</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>復元: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>このモデルは調整用です。「設計を編集」ですべて元に戻ります。</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>ヘルプ: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>板を提案</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>枚数</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>提案</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>その形を表し、互いに支え合い、自立する板を見つけます</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>もう 1 枚</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>今ある板の間に収まる板を加えます</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>別の案</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>最後の板の代わりに別の板を提案します</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>多面体</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面の数</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>多面体にする</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>辺にフィンガーの付いた平らな板で組み立てます。先にメッシュをこの数の面まで単純化し、同じ平面にあるものは 1 枚の板にします。</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>展開</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>1 枚または数枚の厚紙から切り出し、筋入れの線に沿って折れるように平らに広げます。つなぐ辺には同じ番号が付きます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>マーク %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>彫刻</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>筋入れ</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>このマークを削除</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>文字の高さ</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
</context>
<context>
    <name>fff::ui::MassEdit</name>
    <message>
        <source>g</source>
        <translation>g</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureMarks</name>
    <message>
        <source>%1   X %2  Y %3  Z %4</source>
        <extracomment>a length, and how far it goes along X, Y and Z</extracomment>
        <translation>%1   X %2  Y %3  Z %4</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureText</name>
    <message>
        <source>%1&#x202f;kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>%1&#x202f;g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>%1&#x202f;in²</source>
        <translation>%1 in²</translation>
    </message>
    <message>
        <source>%1&#x202f;cm²</source>
        <translation>%1 cm²</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeshImport</name>
    <message>
        <source>Reading %1…</source>
        <translation>%1 を読み込んでいます…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 はモデルには大きすぎるため、大きさを %2 にしました。大きさは「下絵」で変えられます。</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 には単位がないため、大きさを %2 にしました。大きさは「下絵」で変えられます。</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>メッシュ、画像、図面 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>貼り付けた画像</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>%1 と同じ縮尺にする</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>ほか %n 件。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>まだ何も描かれていません</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>新しい板</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>次に描く板の材料です</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>材料を編集</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>モデルのどこがたわみ、どこが外れるかを、実際より大きく表示します。モデルは変わりません。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>動きを減らす設定です: スライダーを使ってください</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>どう動くかわかりません。</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>「板のたわみ」をオンにすると、たわみ方がわかります。</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>外れ始めるところを表示しています。</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>%1 たわみます（%2 倍で表示）。</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>%1 たわみます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>名前付きの変数</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>名前は文字と数字からなる単語です。「t」と単位は使えません。</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>この変数を削除</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>板 %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>混在</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>%1 以上です。</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>%1 以下です。</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>端材</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>別のサイズのシート。新しいシートより先に使われます</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>図面から…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>シートの残り。実寸の SVG ファイルの最大の輪郭線と、その穴</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>端材の幅</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>端材の高さ</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>この端材の枚数</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>この端材を外す</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1、図面から</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationMarks</name>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a number (&quot;From&quot;), %2 its value</extracomment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationNotices</name>
    <message>
        <source>Choose another</source>
        <translation>別のものを選ぶ</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>表示する</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>上限を上げる</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>このままにする</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>選ぶ</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>例外</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>板に変換</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>作るものを描いた板に変えます。オペレーション自体はなくなります</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>オペレーションと、それが作るものをすべて削除します</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>選ぶ</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>上限を上げる</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>オペレーション（実行順）</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 で名前を変更、Space で表示・非表示、Alt+矢印キーで順番を変更します。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>非表示: 表示する</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>隠す</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>名前または材料で絞り込み</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>板</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 で名前を変更、Space で表示・非表示を切り替えます。</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>描いた板がここに並びます。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1（描画中）</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>ロック中: 解除する</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>ロックする</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>非表示: 表示する</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>隠す</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>左ボタンを押したまま、ここに形を描いてください。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1、ここにほか %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>スリットを計算中…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>前の点から %1 × %2</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>スリットでミラー</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>垂直線でミラー</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>地面で平らに切る</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>地面はこの縁の %1 下</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>スリット %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>スリット %1、%2</translation>
    </message>
</context>
<context>
    <name>fff::ui::ParameterRow</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>As it follows from the sections</source>
        <translation>板から決まる値です</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>手動で設定しています</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>部品リスト</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>No.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>個数</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>物理</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>応力線</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>表示の下限</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>シートの強度に対する割合です。これより小さいものは表示しません</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>有限要素法</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>板のたわみ</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>接合部が荷重を分け合うところでは、板の硬さによって受け持つ量が決まります。少し時間がかかります。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>強度マップ</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>すでに載っているもののほかに、各場所があとどれだけの質量に耐えるかで、選択した板を色分けします。少し時間がかかります。</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>いちばん弱いところ</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>荷重</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>モデルにおもりを載せて、どれだけ耐えるか調べましょう。</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>自重</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>地面にかかる力</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>おもりを追加</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>押す力を追加</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>判定の厳しさ</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>安全率</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>荷重の何倍に耐えられれば「耐える」と判定するか</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>切欠き係数の上限</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>内側の角で応力がどれだけ高まるかは、くびれの長さから決まり、この係数が上限です。端の丸いスリットなら小さくできます</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>何か月も</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>荷重の継続</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>その場合、材料の耐える量は材料ごとの設定に従って減ります: アクリルでは 4 分の 1 だけです</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>what a weight or a push is called, and the section that it is on
----------
the name of a section, and a place in it such as &quot;at its neck&quot;</extracomment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Remove this push</source>
        <translation>この押す力を取り除く</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>このおもりを取り除く</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>計算中… %1%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>計算できませんでした</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>選択した板</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>板を選択してください</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>板を描いて、どれだけ耐えるか調べましょう。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>耐えるかどうかを計算できませんでした。</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>変更前の結果です。計算中…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>自立しないため、応力は表示しません。</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>接合部が抜けるため、応力は表示しません。</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>強度が不明: 強度のわからない材料があります。「材料」で強度を設定してください。</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>最新の結果です。接合部の荷重の分け方はいろいろありえるので、最悪の場合で判定します。</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>最新の結果です。すべての力が釣り合っています。</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 %2 たわみます。</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1、%2: %3%</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>across its slit</source>
        <translation>スリットを軸に</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>垂直線を軸に</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>水平線を軸に</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>独立</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>取り付け先の板と一緒に動かず、角度も保ちません</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>取り付け先の板が動かないかぎり、このまま変わりません</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>片方の点への変更が、もう片方にも反映されます</translation>
    </message>
    <message>
        <source>On</source>
        <translation>取り付け先</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>取り付ける別の板をクリックしてください</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>どの板にも取り付けられていません</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>取り付け角度</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>追従</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>比例して</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>左端に</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>右端に</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>下端に</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>上端に</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>変数で取り付け先の板が伸び縮みするときの位置の変わり方です: その場所の伸びに合わせるか、端からの距離を保ちます</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>中心の X</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>中心の Y</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>中心の Z</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>面の向きの X（長さ 1）</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>面の向きの Y（長さ 1）</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>面の向きの Z（長さ 1）</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>向き</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>入側ハンドル</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>入側の角度</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>出側ハンドル</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>出側の角度</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>コーナー</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>スムーズ</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>対称</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>変更あり</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>プリセットの名前</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5、棚 4 段 …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>今の設定をプリセットとして残す</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>このプリセットを削除</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>プリセットとして残す</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>今の設定に A5 などの名前を付け、後で呼び出せるようにします</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 外側</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 内側</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 高すぎる</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>プロパティ</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>「チェック」にほか %n 件。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>On</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>オフにすると何も作りませんが、設定は残ります</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>joint</comment>
        <extracomment>the names of two sections that meet</extracomment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is a mass or a force, %2 the name of a section</extracomment>
        <translation>%2 に %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>何も選択されていません</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>変更はすべてに反映されます</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>重なっています</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · 自動</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · 手動設定</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>接合部 %n か所</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>%1 で作成 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>板 · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>板 · 取り付け先 %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · オフ</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · 何も作らない</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · 最新</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（見つかりません）</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>この一覧を消去</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>名前を一覧から消します。ファイルは残ります</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>注意すること</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>これを閉じて、モデル内で選択します</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>ファイルの置き換え</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>既存のファイル %n 個を置き換えますか？</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>このファイルを置き換えますか？</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>水平距離</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>リブに沿って、リングからリングまで</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>リブに沿って、下のリングまで</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>アーチ</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>横ずれ</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>軸_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>軸_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>横桁</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>横桁の並び</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>腹のリブ</translation>
    </message>
    <message>
        <source>between</source>
        <translation>リング間</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>棚板</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>棚板の並び</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>棚板数</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>胴体</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>枝</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>大文字高</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>column</source>
        <translation>列間隔</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列数</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>受け台</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>受け台高</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>飾り板</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>カトラリー</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>軸間距離</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>仕切り</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>仕切りの並び</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>耳</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>奥の台</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>奥の踊り手</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>奥の傾いた踊り手</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>奥の踊り手たち</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>モミの木</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>交差するモミの木</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>底板</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>足</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>前脚</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>フォークとティースプーン</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>棚板四枚</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>軸から軸までの水平距離</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>軸から軸まで（少し遊びあり）</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>壁板から壁板まで</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>前の足</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>前脚</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>前の横木</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>前の波</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>コップの水</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>取っ手</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>大文字の高さ（長い名前では小さく）</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>受け台の高さ</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>小歯車の軸の高さ</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>大歯車の軸の高さ</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>後ろの足</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>後ろ脚</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>後ろの波</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>腰</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>大あご</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>リブが上のリングと交わる位置の、下の位置からの横ずれ</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>各リブの傾き</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>大歯車から見て、小歯車がどれだけ低いか</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>札の幅が大文字の高さの何倍か</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>札の幅</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>スパイス瓶</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>最後のリブ</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>左足</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>左の葉</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>左の側板</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>左の帯板</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>左の翼</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>脚</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>脚の並び</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>脚数</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>文字高</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>長い足</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>リング下</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>下のリング</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>下の背もたれ</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>中央の台</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>中央の踊り手</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>中央の傾いた踊り手</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>中央の踊り手たち</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>中央のリブ</translation>
    </message>
    <message>
        <source>module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>マグカップ</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>鼻先</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>名札</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>手前の台</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>手前の踊り手</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>手前の傾いた踊り手</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>手前の踊り手たち</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>首</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>リブに沿って測った高さ</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>棚板の端から端まで</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>引き出しの内寸</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>グラスの直径</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>いちばん高い壁板の高さ</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>歯の谷が大歯車を向く位置からの、小歯車の回転</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>小歯車も同様</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>側板の奥行き</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>側板の高さ（飾り板はもっと高い）</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>大歯車の値</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>大歯車の中心から歯底まで</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>大歯車の中心から歯先まで</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>反対側の足</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>反対側の橋脚</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>反対側の手すり</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>反対側の側板</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>反対側の土台</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>反対側のつま先</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>回転位置</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>橋脚</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>小歯車</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>小歯車歯数</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>小歯車の歯</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>小歯車半径</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>小歯車歯底半径</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>小歯車_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>背板</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>札幅</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>背板の並び</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>手すり</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>ひれの骨</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>ひれの骨の並び</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>後ろのリブ</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>余り</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>リブ</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>リブの並び</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>リブ数</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>右足</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>右の葉</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>右の側板</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>右の帯板</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>右の翼</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>リング</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>輪に並んだ穴</translation>
    </message>
    <message>
        <source>root</source>
        <translation>歯底半径</translation>
    </message>
    <message>
        <source>row</source>
        <translation>行間隔</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>ねじ</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>座面</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>棚板</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側板</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>側板の並び</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>土台</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>歯の大きさ: 直径 ÷ 歯数</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>スライス</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>小さめのグラス</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>背骨</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>スプーンとナイフ</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>太陽</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>尾</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>歯列</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>歯数</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>小歯車の歯の数</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>同じ回転から、歯の整数枚分を除いた残り</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>棚板三枚</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>傾斜角</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>支え材</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>支え材の並び</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>つま先</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>幹</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>タンブラー</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回転角</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>小枝</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>ひねり</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>上のリング</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>上の背もたれ</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>首の骨</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>尾の骨</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁板</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>クジラ</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>シートに収まる高さ</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>大歯車</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>大歯車の歯がある位置</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>幅広</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>幅比</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>魚</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>ダックスフント</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>モミの木</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>ランプシェード</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>人形のいす</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>グラスホルダー</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>デスク整理箱</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>棚</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>引き出しの仕切り</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>名札</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>グラススタンド</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>メッシュをなぞったクマ</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>画像から作ったフクロウ</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>スライスのハリネズミ</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>魚の骨</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>恐竜</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>クワガタ</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>育つ木</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>2 つのポーズの踊り手</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>歩道橋</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>歯車</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>セルに分けたクジラ</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>カトラリー人形</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>三本脚のグラス台</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>細い脚 3 本: 弱すぎる</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>細い脚 4 本: 弱すぎる</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>太い脚 3 本: ぎりぎり</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>太い脚 4 本: 安全</translation>
    </message>
</context>
<context>
    <name>fff::ui::ScaleBar</name>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
</context>
<context>
    <name>fff::ui::SearchWords</name>
    <message>
        <source>begin create empty blank</source>
        <translation>始める 作成 作る 空 新しい</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>読み込み インポート 開く flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>追加 結合 合体 取り込み</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>セーブ 保管 書き込み</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>コピー 名前変更 別名</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>読み直し 再読み込み 破棄</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>印刷 出力 エクスポート レーザー レーザーカッター CNC プロッター svg dxf pdf gcode lightburn 加工 製作</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>環境設定 オプション 構成 ダーク ライト テーマ 言語 単位 インチ マウス 操作 自動保存 アニメーション</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>キー ホットキー キー割り当て キーボード</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>やめる 閉じる</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf インポート 読み込み</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf インポート 読み込み 彫刻</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj 画像 写真 トレース なぞる 参考 背景 下絵</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>戻る 取り消し アンドゥ</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>もう一度 進む リドゥ</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>クリップボード ペースト</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>コピー クローン</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>反転 鏡 左右対称 鏡像</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>消す 取り除く ごみ箱</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>全部 全て</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>探す 検索 パレット</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>ズーム 中央 全体 ホーム</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>ズーム フォーカス 拡大</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>正面 真正面 まっすぐ</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>平行投影 等角 アイソメ 透視 パース カメラ</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>透明 半透明 ワイヤーフレーム 透視 X線 レントゲン</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>断面 スライス 内部 半分 切る</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>表面 外皮 殻 カバー</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>ソロ 単独 分離</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>再表示 見せる 表示</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>非表示 見えない</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>グリッド 床</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>共有 渡す カスタマイズ 設定 生徒 授業 調整 スライダー ロック 全画面</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>最大化 フルスクリーン</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>サイドバー</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>レイアウト 既定 初期化</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>ミラー 鏡 半分 左右対称</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>床 足 底</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>磁石 吸着 整列 ガイド</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>多角形 線 曲線 ベジェ パス</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>円 正方形 長方形 四角 多角形 星</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>文字 刻印 彫る テキスト ラベル</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>動かす 移動 回転 回す 拡大縮小 サイズ</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>開口 窓 切り抜き</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>置き換え やり直し</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>配列 パターン 繰り返し 並べる 直線 リブ</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>回す 周り 回転</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>ロフト モーフ 中間 補間</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>木 枝 分岐</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>ワッフル グリッド 分割 格子</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>スポーク 車輪 歯車 円形</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>回転 円形 パターン</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>パターン 繰り返し コピー 並べる</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>ワッフル 層 積層 stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>ベイク 展開 適用 確定</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>エラー 警告 不具合</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>組み立て 説明書 アニメーション 再生 手引き</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>強度 折れる 壊れる シミュレーション 物理 FEM 有限要素法</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>荷重 質量 力 重り 重さ</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>力 荷重</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>素材 厚さ 板厚 合板 ベニヤ アクリル カーフ 切りしろ</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>試し切り 試験片 カーフ クリアランス スリット くし</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>ネスティング レイアウト 配置 板取り</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>長さ 距離 大きさ 寸法 計測</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>拡大縮小 サイズ 大きさ スケール</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>マニュアル チュートリアル 使い方 ガイド 説明書</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>ホーム ようこそ 例</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>バージョン ライセンス</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>接合部</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>材料を編集</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>材料の厚さです: この材料の板すべてが変わります</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>ほかと同じ</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>シート上での部品の回し方です: 木目に合わせるものは、描いたとおりか 180° 単位で置かれます</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>長さを変えると、スリットまたは中心を基準に輪郭が伸び縮みします</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SegmentedBox</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is the name of a choice (&quot;Side&quot;), %2 one of what can be chosen (&quot;Both&quot;)</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>設定の分類</translation>
    </message>
    <message>
        <source>General</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>チェック</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>キーボード</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>ミリメートル（mm）</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>センチメートル（cm）</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>インチ（in）</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>表示と入力に使う単位です。ファイルは常にミリメートルです。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>システムと同じ</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>ハイコントラスト</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>再起動後に有効になります。</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>起動時にスタートページを表示</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>回転時間</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>描いている間に、ビューが新しい平面へ向くまでの時間です。0 では一瞬で切り替わります。</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>ビューの回転角</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>90° では新しい平面を真正面から見ます。小さくすると、描き始めた板も見えたままになります。</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>線が下絵に沿う距離</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>マウスボタンの方式</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>ビューの回転・移動・ズームに使うボタンです。Ctrl+左ボタンは常に回転、Space+左ボタンは移動です。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>いつも</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>できるだけ少なく</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>「できるだけ少なく」では、ビューは回転せず一瞬で切り替わります。</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>色覚に配慮した応力の色</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>青から赤ではなく、明から暗で表します。ハイコントラストでは常にこの色です。</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>警告する角度（未満）</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>2 枚の板の交わる角度が浅いほど、スリットを広くする必要があります。</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>無視する重なり（未満）</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>重なりがこれより小さければ問題とみなしません。</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>組み立て順を探す時間</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>変更のたびにバックグラウンドで行います。チェックで組み立て順が見つからないときは、時間を増やしてください。</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>安全率</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>モデルが荷重の何倍に耐えれば「強度は十分」とみなすかです。</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>切欠き係数の上限</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>内側の角で応力が何倍に高まるとみなすかです。</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>荷重が何か月も続く</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>未保存の作業のバックアップ間隔</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>異常終了や停電の後、一度も保存していなくても元に戻せます。元のファイルには手を加えません。</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>保存するときに前の版を残す</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>シンプルなウィンドウ</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>描く、チェックする、書き出すためだけの表示です。ほかは隠れます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Sheet</name>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>K40 laser</source>
        <translation>K40 レーザー</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>合板 1 枚まるごと</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>シート上</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>位置 X、Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>この場所に固定</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>ピン留め</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>シート上で選択した部品を P でピン留め、または解除します</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>シートより大きい</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1、最初の部品</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm、大きさの確認用</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>カットするとおりのシート</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>+ と − で拡大縮小、矢印キーで移動、Home で全体を表示します。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>端材 %1 はそのまま残ります</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>速い</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良い</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最良</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>板取りの質</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>「速い」はすべての部品を並べ直します。「良い」は約 10 秒かかります。「最良」は止めるまで続きます。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>格子で分割</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>ピン留めをすべて解除</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>板を描くと、カットできる形でここに並びます。</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>板取り中…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>板取りをやり直し中…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>ピン留めした部品 %n 個は、元の場所に収まりませんでした。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 はシートより大きいです。</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 とほか %n 枚はシートより大きいです。</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>端材を追加</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>シートが %n 枚足りません</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · カット長 %2</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>これまでの最良を残します（%1 秒）</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>板取り中… %1% を使用</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1、%2 · %3% を使用 · カット長 %4</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>カットするとおりのシート</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>PageUp と PageDown で部品を順に選び、矢印キーで部品を 1 mm 動かし、R で回し、P でピン留めします。+ と − で拡大縮小、Home ですべてのシートを表示します。</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · 回転 %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>そこには収まりません。</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>そこまで細かい角度には回せません。</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>描いたとおりの向きで置かれます。</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>シート %1/%2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>大きすぎる</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>木目 ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · 部品 %n 個 · %1% を使用</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>端材、シート %1 / %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>ピン留め: この位置に残ります。クリックで解除します。</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>部品をドラッグして移動するか、クリックして選択します。</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>クリックで &lt;b&gt;%1&lt;/b&gt; のピン留めを解除します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; はシートに入りきりません。クリックで選択します。</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; をドラッグして移動するか、クリックで選択します。</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; をドラッグして移動します。&lt;kbd&gt;R&lt;/kbd&gt; で回転、&lt;kbd&gt;P&lt;/kbd&gt; でピン留めします。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>名前またはキーで絞り込み</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>このコマンドのキーをなくします</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>このコマンドのキーを初期状態に戻します</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべてリセット</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>すべてのコマンドのキーを初期状態に戻します</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>ここで使う</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>コマンドとショートカット</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>ビューの中</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>どこでも</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>コマンドを選んでください</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>%1 のキー:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>変更済み</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 だけでは文字入力のじゃまになります。Ctrl か Alt と組み合わせてください。1 つだけのキーは、ビューで使うコマンド用です。</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 は「%2」に割り当てられています。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>%1 の間では大きくふくらんでしまいます: 交差する板をもう 1 枚足すと、ふくらみが決まります。</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>%1 の間では自分自身に折り重なってしまいます。</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>%1 の間がどうなるかは、輪郭からは決まりません。</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>スキン: 計算中… %1%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>スキン: 計算中…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>スキン: 中止しました</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>スキン: 計算できませんでした</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>スキン</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>スキン: 覆うものがありません</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>スキン: 輪郭が交わっていません</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>クリックで中止します。</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>スキンには、互いに交わり、そこで同じ位置に縁がある板が必要です。</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>パッチ %n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1。%n か所は開いたままです。</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>クリックで板だけの表示に戻ります。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>四角</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>丸</translation>
    </message>
    <message>
        <source>Dogbone</source>
        <translation>ドッグボーン</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T ボーン</translation>
    </message>
    <message>
        <source>Slit end</source>
        <translation>スリットの端</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>スリットの奥の端です。レーザーなら四角くカットできますが、フライスの丸い工具は角に届きません。丸: 四角の先を丸くします。ドッグボーン: 各角に円弧を付けます。T ボーン: 両側の壁に円弧を付け、底は平らなままです。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>フライスの工具の直径です。工具が回り込めるように、円弧は少し大きく描かれます。</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>四角い端に工具の設定はありません。フライスの場合はほかの端を選んでください。</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>入口面取り</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>スリットの入口の両側の壁に付ける 45° の面取りで、板を差し込みやすくします。ふつうは厚さの半分から同じくらいまでです。0: なし。</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>摩擦用の突起</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>スリットの両側の壁に付ける小さな突起の高さで、中の板を押さえます。クリアランスの半分より大きくしてください。0: なし。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>板</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>生成された板</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>取り付け先 %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>問題あり</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>問題なし</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>%1 と %2 の接合部</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1、オペレーション</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%2 の %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>板 %n 枚を選択中</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>自分のモデルを描きます</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>モデルを開きます。FlatFab のモデルも開けます</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>アカウント不要。データはこのコンピューターの外に出ません。</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>起動時に表示</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>復元: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>この一覧から外す</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>コピーを開く</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>3 分で最初のモデル</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>モデルを描き、チェックし、カットするまでを一歩ずつ</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>次の操作でできること</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>板の枚数</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>モデルの大きさ</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>モデルの質量</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>すべての長さの単位</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>「%1」を元に戻しました。</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>「%1」を元に戻しました。&lt;kbd&gt;%2&lt;/kbd&gt; でやり直せます。</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>「%1」をやり直しました。</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>「%1」をやり直しました。&lt;kbd&gt;%2&lt;/kbd&gt; で元に戻せます。</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>組み立ての手順</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>手順の書き出し…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>手順を閉じる（Esc）</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>前の手順（←）</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>再生（Space）</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>次の手順（→）</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>部品を引き離して表示します</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>分解表示</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>一時停止（Space）</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>全手順を印刷用の PDF、スマートフォン用のウェブページ、または手順ごとの画像に書き出します</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>全手順、印刷用 (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>画像、手順ごとに 1 つ (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>手順の書き出し</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 を書き出しています…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>何も書き込んでいません: 書き出しがキャンセルされました。</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>手順を書き出せませんでした: このディスプレイでは画像を作れません。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n 手順</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>%1 を %2 に書き出しました。</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>%1 を %2 … %3 に書き出しました。</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>別の場所に書き出す…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>ウェブページ (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>このブラウザではモデルを 3D で表示できません。ここに手順を順番に示します。</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>画像はありません: このページを書き出したコンピューターのディスプレイでは画像を作れませんでした。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>ドラッグで回転、2 本指またはホイールで拡大、2 回タップで全体を表示します。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>前の手順</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次の手順</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部品</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>部品 1 個</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>部品 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>シート 1 枚</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>シート %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 手順</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n 手順</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>%1/%2 ページ</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>組み立て方</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%2 から %1、全 %3。</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>番号は部品に彫刻されたものです。各スリットには、短い線の後に接合部の番号があり、両方の部品で同じ番号です。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>ほか %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1、全 %2。</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>モデルが変わったため、手順は表示しません。</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>このディスプレイでは手順を表示できません。</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>手順は表示しません。</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>組み立て順を計算中です。わかり次第、手順を表示します。</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>手順を表示できません: %1。</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>組み立て順がわかりました。「手順を表示」で表示します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;まだ何もありません。&lt;/b&gt; 手順 1: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1:&lt;/b&gt; %2</source>
        <extracomment>%1 is &quot;Step 4 of 38&quot;, %2 what is done in it</extracomment>
        <translation>&lt;b&gt;%1:&lt;/b&gt; %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>Birch plywood</source>
        <translation>バーチ合板</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>バーチ合板 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>バーチ合板 6.5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>バーチ合板 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>アクリル</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>アクリル（透明）</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>アクリル（赤）</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>段ボール（B 段）</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>段ボール（C 段）</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>段ボール（E 段）</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>厚紙</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>シナ材</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>アルミ 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation>新しい板に %1 を使う</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: 厚さ %2 → %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>次の板の材料</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>次の板の材料: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>材料…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>シート 幅 × 高さ</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 は不明です</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>シートの価格</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>シートの幅</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>シートの高さ</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>よくあるシート</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>引張強さ</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>曲げ強さ</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>折れる前に曲がる</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>曲がり</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>金属のように、この強さを超えると曲がったまま戻りません</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>長期の強度</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>荷重がかかり続けるときの強度の割合です: アクリルはゆっくり変形し、細かいひびが入ります</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>カット</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>切断幅（全幅）</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>クリアランス</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>スリットの描画幅</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>スリット</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>未設定</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 は未設定です</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>この材料の板はありません</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>なし: 切断幅がスリットより広くなっています</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>直角に交わるこの材料の板 2 枚の、厚さ、クリアランス、切断幅から</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>販売時の厚さ</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>シートを買うときの厚さ。実際はたいてい少し違います</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>ノギスで測りました</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>エクスポート時に一度だけ、切るシートの厚さを尋ねます</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>必要なだけ</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 は必要なだけを意味します</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>手元の枚数</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>先に使うもの</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>図面からの端材</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>図面 (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>加工機ごと</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>エクスポートでその加工機が選ばれているときに入力された切断幅です</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>サイズと枚数</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>このモデルの材料</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>材料の一覧から追加します</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>同じ数値の材料を追加します</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>この材料を、ほかのモデルやほかの人のためにファイルに保存します</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>材料をファイルに保存</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>材料を取り除きます</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>板 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>モデルには材料が必要です。先に別の材料を追加してください</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>この材料を取り除く</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>ファイルから…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>ファイルから材料を追加</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>FlatFitFab モデル (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>板 %n 枚の新しい材料</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>材料 %1 を追加</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>材料 %1 を取り除く</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressCard</name>
    <message>
        <source>%1&#x202f;MPa, %2&#x202f;%</source>
        <extracomment>%1 is a stress in megapascals, %2 a number of percent</extracomment>
        <translation>%1 MPa、%2%</translation>
    </message>
    <message>
        <source>In the neck</source>
        <translation>くびれ</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>面内の曲げ</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>面外の曲げ</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>圧縮</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>引張</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>ねじり</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>とても細いため、折れる前に座屈するおそれがあります。</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>不確かな値です: またいでいる穴の脇に力が働いています。</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>大まかな値です: くびれが短すぎるか、力に近すぎます。</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>先に角にひびが入ります。</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>まっすぐ横に折れます。</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1%</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>応力</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>安全率 %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>強度が不明</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1% を超えるところなし</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>動き %1 ×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>自立しないため、応力は表示しません。</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>接合部が抜けるため、応力は表示しません。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>耐えるかどうかを計算できませんでした。</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>板を探しています…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>多面体を作成中…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>展開中…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>%1 をトレース中…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>板 %n 枚を作りました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>先に穴をあける板を選択するか、図面をその板の上に置いてください。</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>先に彫刻する板を選択するか、図面をその板の上に置いてください。</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>平面を探しています…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>毎回読み込み</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>モデルに保存</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>ファイルを探す…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>今ファイルがある場所から読み込みます。位置は変わりません</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>ファイルにリンク…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>モデルのファイルに含めず（小さくなります）、毎回元の場所から読み込みます</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>モデルに保存する</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>ほかのコンピューターでも使えるように、モデルのファイルに含めます</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>ビューの中で、ハンドルまたは数値で移動・回転・拡大縮小します</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>線で大きさ指定</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>長さのわかるところに線を引きます</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>移動と回転</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>下絵を追加…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>メッシュ、画像、図面を読み込み、それをなぞって板を描けるようにします</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>メッシュ、画像、図面を追加してください。ドロップや貼り付けもできます。描く板は、その平面がメッシュを切るところと、その平面にある図面の線にスナップします。</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 で名前を変更、Space で表示・非表示、L でロック、Delete で取り除きます。</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>スライス…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>形に沿った板に切り分けます</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>位置と大きさ</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>寸法</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>地面に置く</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>地面の上に置きます</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>立てる</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>別の面を下にします: 元の上方向が、ビューでも上になります</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 が見つかりません</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>ロックを解除</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>中心の X</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>中心の Y</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>中心の Z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>X のまわりの回転（最初）</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Y のまわりの回転（X の後）</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Z のまわりの回転（最後）</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>メッシュ、三角形 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>画像、%1 × %2 ピクセル</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>図面、線 %n 本</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>この手順をとばす</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>ツアーを終える</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>ツアー、手順 %1 / %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;見回しましょう。&lt;/b&gt;モデルの横をドラッグすると回り、ホイールで近づきます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;カットしましょう。&lt;/b&gt;&lt;b&gt;書き出し…&lt;/b&gt;はシートを表示し、カット用のファイルを書き出します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;胴体を描きましょう。&lt;/b&gt;ビューの真ん中でボタンを押し、上が平らな輪郭を地面まで一筆で描きます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;それを横切る板を描きましょう。&lt;/b&gt;胴体の内側でボタンを押し、縁を越えて外へドラッグします。押したままにするとビューが回ります。続けて輪郭をまた地面まで描きます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;シートを測りましょう。&lt;/b&gt;ツールバー右側の材料、次に厚さをクリックし、測った値を入力すると、すべてのスリットが合わせて変わります。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;うまくいくでしょうか。&lt;/b&gt;ビューの上のバッジでわかります。クリックすると詳しく読めます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;くり返しましょう。&lt;/b&gt;&lt;b&gt;列&lt;/b&gt;を選び、横切る板、次に胴体をクリックすると、コピーが胴体に沿って並びます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;これで全部です。&lt;/b&gt;最初の一筆からファイルまで進みました。赤いものは「チェック」のリンクで直せます。続きは &lt;b&gt;F1&lt;/b&gt; でどうぞ。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;あと少しです。&lt;/b&gt;列の端の丸いハンドルを、赤いバッジがなくなるまで戻します。そのあと&lt;b&gt;書き出し…&lt;/b&gt;でカット用のファイルを書き出します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;とても小さい形です。&lt;/b&gt;取り消して、ビューの幅の半分くらいの大きさに描き直しましょう。</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;ツアーはここで終わりです。&lt;/b&gt;&lt;b&gt;ヘルプ&lt;/b&gt;メニューからもう一度始められます。続きは &lt;b&gt;F1&lt;/b&gt; でどうぞ。</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>異常終了に備えたバックアップができません。念のため保存してください。</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>この作業は、別のウィンドウで開かれたか破棄されました。</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>バックアップを開けませんでした: %1。</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1、%2、%3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>操作 %n 回</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>未保存の作業のコピーが、新しいバージョンの FlatFitFab で作られています。%1 に残してあります。</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>未保存の作業のコピーを読み込めませんでした。%1 に残してあります。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比率</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>はい・いいえ</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>small</source>
        <translation>小</translation>
    </message>
    <message>
        <source>large</source>
        <translation>大</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>選択肢</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>小 | 大</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>計算式</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>上に付ける見出し</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>何に使うか</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>ここに必要なものとして読み取れません。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>any</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>刻み</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>ほかの人も調整できる</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>設計を調整用に配布したとき、ほかの人が設定できます</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>これを使っているところは、ただの数値になります</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueEditor</name>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRow</name>
    <message>
        <source>Name of the value</source>
        <translation>変数の名前</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>種類、範囲、メモ</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>自分だけ</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>範囲を狭めました: %1。</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>試した %n 通りはすべて合格です。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is what is wrong, such as &quot;Falls over&quot;, %2 in how many places it is</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n variant(s) fail: %2.</source>
        <extracomment>%1 is a number, %2 a list such as &quot;Falls over (5), Breaks (2)&quot;</extracomment>
        <translation>
            <numerusform>%n 通りのうち %1 通りが不合格: %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>範囲の端 %1 通りのうち %2 通りを試しました。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a value, %2 what it is: &quot;width 400 mm&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;width 400 mm, boards 6&quot;, %2 what is wrong there</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n other(s)</source>
        <translation>
            <numerusform>ほか %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>範囲を試しています… %1%</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度試す</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>すべての範囲を試す</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>範囲を狭める</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>表示されている変数の範囲のどこで、モデルが組み立てられない、折れる、倒れる、収まらないかを調べます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新しい変数</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>変数</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>この設計は調整用です: 変数を設定してから書き出してください。ビューをドラッグすると回せます。</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>%1 からカットします。</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>この設計に調整できるものはありません。</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>設計を編集</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>調整用に配布</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>描画とすべてのパネルを元に戻します。今保存すると、ファイルはその状態で開きます。</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>保存したモデルを開いた人には、ビュー、公開された変数、書き出しだけが見えます。</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>数値に名前を付けると、どの入力欄でも使えます。= 2*すき間 のような計算にも使えます。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>モデルの表示方法</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>透過表示</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>クリックで板を元の表示に戻します。</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>クリックでモデル全体の表示に戻します。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>上</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>下</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>前</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>後</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>右</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>左</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>モデルのビュー</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>マウスの左ボタンで描き、右ボタンで回します。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 工房用</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>ファイルに手順は含まれません: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>フォルダー「%1」の置き場所</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>ここに置く</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>このディスプレイでは画像を作れません。</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>平らな部品を 3D で描き、カットします。</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>開くモデル（それぞれのウィンドウで）。図面、メッシュ、画像は新しいモデルに追加します。</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>FILE をコピーとして開きます。保存するときに名前を尋ねます。</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>ボタンを押す・動かす操作のスクリプトを再生します。</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>保存された設定を使わずに起動し、設定も保存しません。</translation>
    </message>
</context>
</TS>
